/**
 * @file smCensusSamples.h
 * @brief Small STEP texts that tests of the census change: a ball, an assembly, and many levels of assemblies
 */
#ifndef smCensusSamples_h
#define smCensusSamples_h

#include <string>

namespace smtest
{
/// Returns the entities of a ball of one face in one product; some of its numbers: #6 context, #24 sphere,
/// #28 bound, #29 face, #30 shell, #31 solid, #32 representation, #44 product definition, #46 shape
/// definition.
std::string GetBallText();
/// Returns an assembly "box" in which the ball occurs once, to be appended to the ball; #52 is its product
/// definition, #60 the occurrence, #64 its placement.
std::string GetAssemblyText();
/// Returns a whole file with this data section.
std::string MakeStepText(const std::string& data);
/// Returns `text` with the first `from` replaced; throws std::logic_error when there is none.
std::string Replace(std::string text, const std::string& from, const std::string& to);

/// Returns a file of the ball with one text replaced, and with more entities.
std::string ChangeBall(const std::string& from, const std::string& to);
std::string ExtendBall(const std::string& from, const std::string& to, const std::string& more);

/// Returns a file with a ball in levels of assemblies, each with one or two occurrences of the one below.
std::string MakeLevels(int levels, int occurrences);
}

#endif
