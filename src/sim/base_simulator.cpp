#include "fourwis_navigation/sim/base_simulator.h"
