#include "bearing/geometry.hpp"
