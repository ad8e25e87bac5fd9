#include "verification/case.hpp"
