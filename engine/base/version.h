#pragma once
// The program's version; CMake and the package read it here.

#define BASK_VERSION "0.2.0"
