// A library that is none of our kernels.
extern "C" int some_function() { return 1; }
