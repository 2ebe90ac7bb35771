/**
 * @file smJson.h
 * @brief The JSON type of the example programs: keys keep their order
 */
#ifndef smJson_h
#define smJson_h

#include <nlohmann/json.hpp>

namespace sm
{
using Json = nlohmann::ordered_json;
}

#endif
