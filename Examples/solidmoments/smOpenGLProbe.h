/**
 * @file smOpenGLProbe.h
 * @brief Prints what the OpenGL driver makes of the constructs of the shaders
 */
#ifndef smOpenGLProbe_h
#define smOpenGLProbe_h

namespace sm
{
/// Prints driver and table to the standard output. Returns the exit status: UsageOrOutput if there is no
/// context that can compute, or if a construct that shaders use is wrong.
int PrintOpenGLProbe();
}

#endif
