#include "engine/shape/dxf_outlines.h"
#include <gtest/gtest.h>
