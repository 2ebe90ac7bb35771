// (s, e) with s = fl(a + b) and s + e = a + b exactly, barring overflow (Knuth, TAOCP 2, 4.2.2, theorem B).
dvec2 smTwoSum(double a, double b)
{
  precise double s = a + b;
  precise double t = s - a;
  precise double e = (a - (s - t)) + (b - t);
  return dvec2(s, e);
}
