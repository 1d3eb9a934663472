#include "fourwis_navigation/track/tracker.h"
