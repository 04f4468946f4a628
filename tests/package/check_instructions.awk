# Reads a disassembly, by objdump or llvm-objdump, of a program compiled for plain x86-64. Fails if an AVX instruction (a
# mnemonic that begins with v, or one on mask registers) is in a function that is not of the kernels: the program's own,
# the library's around the kernels, or one that a linker merged. Names are mangled: hatbox::avx2::…, or with xsimd's avx
# types in them.
/^[0-9a-f]+ <.*>:$/ {
  is_kernel = $2 ~ /6hatbox(4avx2|6avx512)|N5xsimd.*avx/
  function_name = $2
}
/^ *[0-9a-f]+:[ \t]+(v[a-z]|k(mov|or|and|xor|not|test|shift|unpck|add)[a-z]*[ \t])/ {
  if (is_kernel) kernels[function_name] = 1
  else leaks[function_name] = 1
}
END {
  for (leak in leaks) {
    print "AVX instructions outside the kernels: " leak
    failed = 1
  }
  count = 0
  for (kernel in kernels) ++count
  print "AVX instructions in " count " functions of the kernels"
  exit failed || count == 0
}
