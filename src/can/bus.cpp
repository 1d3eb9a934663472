#include "fourwis_navigation/can/bus.h"
