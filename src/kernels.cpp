// The kernels of one instruction set. Compiled once for each of them, with HATBOX_ISA and, but for scalar, its
// HATBOX_ISA_ARCH (cmake/isa_kernels.cmake); the table is all that an object exports.
#include "disk_kernels.h"

#define HATBOX_NAME_OF(prefix, isa) HATBOX_JOIN(prefix, isa)
#define HATBOX_JOIN(prefix, isa) prefix##isa
#define HATBOX_STRING_OF(isa) HATBOX_QUOTE(isa)
#define HATBOX_QUOTE(isa) #isa

namespace hatbox::HATBOX_ISA {
namespace {

// In the order of DiskMap.
constexpr KernelTable table = {
    HATBOX_STRING_OF(HATBOX_ISA),
    lanes<Packet>,
    {disk_sample<AreaMap>, disk_sample<LdRadialMap>, disk_sample<RadialPolarMap>},
    {disk_pdf_of_direction<AreaMap>, disk_pdf_of_direction<LdRadialMap>, disk_pdf_of_direction<RadialPolarMap>},
    {disk_pdf_of_place<AreaMap>, disk_pdf_of_place<LdRadialMap>, disk_pdf_of_place<RadialPolarMap>},
    {disk_invert<AreaMap>, disk_invert<LdRadialMap>, disk_invert<RadialPolarMap>},
    disk_solid_angle,
    product_residual,
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA

extern "C" {
extern const hatbox::KernelTable HATBOX_NAME_OF(hatbox_kernels_, HATBOX_ISA);
const hatbox::KernelTable HATBOX_NAME_OF(hatbox_kernels_, HATBOX_ISA) = hatbox::HATBOX_ISA::table;
}
