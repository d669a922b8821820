#version 3.7;
#include "quality.inc"
