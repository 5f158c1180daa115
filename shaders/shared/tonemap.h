#ifndef SHARED_TONEMAP_H
#define SHARED_TONEMAP_H
#include "types.h"
SHARED_BEGIN

const uint tonemap_operator_linear = 0, tonemap_operator_aces = 1;

SHARED_END
#endif
