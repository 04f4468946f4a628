/// \file
/// hatbox: area lights sampled uniformly in solid angle, for whole arrays of shading points. This brings all of it.
#pragma once

#include <hatbox/arrays.h>
#include <hatbox/carlson.h>
#include <hatbox/disk.h>
#include <hatbox/disk_table.h>
#include <hatbox/ellipse.h>
#include <hatbox/equiangular.h>
#include <hatbox/export.h>
#include <hatbox/isa.h>
#include <hatbox/light_set.h>
#include <hatbox/lights.h>
#include <hatbox/rectangle.h>
#include <hatbox/triangle.h>
#include <hatbox/version.h>

/// All of the library.
namespace hatbox {

/// The calls on all cores, by TBB.
namespace parallel {}

}  // namespace hatbox
