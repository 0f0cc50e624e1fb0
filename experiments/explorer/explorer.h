#pragma once

// The functions that the explorer page calls, in the browser as WebAssembly and natively in tests: plain C,
// texts in, JSON out. A returned text belongs to the library and lives until the next call.

extern "C" {

/// Takes over the facts that `reproduce` wrote (facts.h). Returns {} or {"error": ".."}.
const char* explorer_set_facts(const char* text);

/// A curve (curve.h): {"points", "length", "area", "polygonArea", "limitArea", "largestJerk", "meanJerk",
/// "polygon": [x, y, ..]} or {"error": ".."}; the arrays by explorer_array. `with_limit_area` is 0 or 1.
const char* explorer_evaluate(const char* request, int with_limit_area);

/// Of the last curve: 0 all x, 1 all y, 2 curvatures, 3 jerks; as many numbers as explorer_size says.
const double* explorer_array(int which);
int explorer_size(int which);

/// What is proved of the limits of *J_{a,b}: {"proved", "refuted", "reason", "claims": [..], "exponent":
/// {"lower", "upper", "formula", "reason", "exact"}} or {"error": ".."}.
const char* explorer_smoothness(const char* a, const char* b);

/// A number as it was read: {"value": "3/8", "double": 0.375} or {"error": ".."}.
const char* explorer_number(const char* text);
}
