/// \file
/// HATBOX_API, which marks what a shared library exports: everything public that is not inline.
#pragma once

#ifndef HATBOX_API                                 // a static library is compiled with an empty one
#define HATBOX_API [[gnu::visibility("default")]]  ///< exported
#endif
