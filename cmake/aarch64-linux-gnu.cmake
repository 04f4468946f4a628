# aarch64 from an x86-64 Debian 12, run under emulation. Besides what ./run installs:
#   dpkg --add-architecture arm64 && apt-get update
#   apt-get install g++-12-aarch64-linux-gnu qemu-user libtbb-dev:arm64 libgtest-dev:arm64 libxsimd-dev:arm64
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++-12)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64)
