// A precompiled header needs a source file that is compiled with it.
