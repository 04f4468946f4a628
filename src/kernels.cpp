// The kernels of one instruction set. Compiled once for each of them, with HATBOX_ISA and, but for scalar, its
// HATBOX_ISA_ARCH (cmake/isa_kernels.cmake); the table is all that an object exports.
#include "carlson_kernels.h"
#include "disk_maps.h"
#include "ellipse_maps.h"
#include "equiangular_kernels.h"
#include "light_kernels.h"
#include "rectangle_area_map.h"
#include "rectangle_map.h"
#include "triangle_area_map.h"
#include "triangle_map.h"
#include "two_triangles_map.h"

#define HATBOX_NAME_OF(prefix, isa) HATBOX_JOIN(prefix, isa)
#define HATBOX_JOIN(prefix, isa) prefix##isa
#define HATBOX_STRING_OF(isa) HATBOX_QUOTE(isa)
#define HATBOX_QUOTE(isa) #isa

namespace hatbox::HATBOX_ISA {
namespace {

constexpr KernelTable table = {
    .isa = HATBOX_STRING_OF(HATBOX_ISA),
    .lanes = lanes<Packet>,
    .disk = {{kernels_of<DiskArea, DiskConstants>, kernels_of<DiskLdRadial, DiskConstants>,
              kernels_of<DiskRadial, DiskConstants>, kernels_of<DiskParallel, DiskConstants>,
              one_way_kernels_of<DiskRejection, DiskConstants>, kernels_of<DiskRadialCarlson, DiskConstants>,
              kernels_of<DiskParallelCarlson, DiskConstants>},
             solid_angle<DiskCone, DiskConstants>},
    .disk_table = {kernels_of<DiskTableLdRadial, TabulatedDisk>, kernels_of<DiskTableRadial, TabulatedDisk>},
    .ellipse = {{kernels_of<EllipseArea, EllipseConstants>, kernels_of<EllipseLdRadial, EllipseConstants>,
                 kernels_of<EllipseRadial, EllipseConstants>},
                solid_angle<EllipseCone, EllipseConstants>},
    .rectangle = {{kernels_of<RectangleArea, RectangleConstants>, kernels_of<RectangleSpherical, RectangleConstants>,
                   kernels_of<RectangleTwoTriangles, RectangleConstants>},
                  solid_angle<RectangleView, RectangleConstants>},
    .triangle = {{kernels_of<TriangleArea, TriangleConstants>, kernels_of<TriangleSpherical, TriangleConstants>},
                 solid_angle<TriangleView, TriangleConstants>},
    .carlson = {rf_kernel, rc_kernel, rd_kernel, rj_kernel, ellint_f_kernel, ellint_e_kernel, ellint_pi_kernel},
    .equiangular = {equiangular_sample, equiangular_pdf, clip_segments},
    .product_residual = product_residual,
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA

extern "C" {
extern const hatbox::KernelTable HATBOX_NAME_OF(hatbox_kernels_, HATBOX_ISA);
const hatbox::KernelTable HATBOX_NAME_OF(hatbox_kernels_, HATBOX_ISA) = hatbox::HATBOX_ISA::table;
}
