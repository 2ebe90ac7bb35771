// A point of a patch in the integrals of gradients: what the polynomials multiply, and bounds of its
// roundings (Documentation/Gradients.md). Needs: smPortable.

// What is the same on a patch, see PatchConstants in smPatchLines.h.
struct smGradientPatch
{
  dvec3 origin;
  double radius;
  dvec2 stretch;
  double off;
  dvec2 offSlope;
  double roundings;
  double additions;
  dvec2 degrees;
};

// What is the same on a line, see PatchLine.
struct smGradientLine
{
  double coverage;
  double side;
  double edge;
  double growth;
  double trimRounding;
};

struct smGradientSample
{
  dvec3 position;
  // With the sign of the outward normal, and without it.
  double weight;
  // n and x.n; the integrals of a moment g are the sum of weight g flux times a polynomial in s and one in r.
  dvec4 flux;
  // Bounds of roundings of the integrals of moments of degree 0, 1, 2, and of x.n with degree 2.
  dvec4 noise;
  // The area's vector and scalar, times polynomials, times derivatives of those in s, and in r.
  dvec4 area;
  dvec4 alongS;
  dvec4 alongR;
  // Bounds of the roundings of the area's vector and scalar, of all control points together.
  dvec2 areaNoise;
};

double smRoundingsOfNormal(smGradientPatch net, double spread, double lengthS, double lengthR)
{
  return (net.roundings + 4.0LF) * spread + net.offSlope.x * lengthR + net.offSlope.y * lengthS;
}

// h, hs, hr: the homogeneous point relative to the patch's centre, and its derivatives.
smGradientSample smMakeGradientSample(
  smGradientPatch net, smGradientLine line, double weight, dvec4 h, dvec4 hs, dvec4 hr)
{
  smGradientSample at;
  double inverse = 1.0LF / h.w;
  dvec3 offset = dvec3(h) * inverse;
  dvec3 ss = (dvec3(hs) - hs.w * offset) * inverse;
  dvec3 sr = (dvec3(hr) - hr.w * offset) * inverse;
  at.position = net.origin + offset;
  dvec3 n = cross(ss, sr);
  double size = length(at.position);
  double normal = length(n);
  double coverage = line.coverage * weight * line.edge * inverse;
  at.weight = line.side * coverage;
  at.flux = dvec4(n, dot(at.position, n));

  // Roundings relative to u: of tangents, those of a sample times the largest steps of the net; of a product
  // of few factors and of its sum, relative to it; of the trim curve, which moves the border; and what the
  // net itself is off.
  double lengthS = length(ss);
  double lengthR = length(sr);
  double stretchS = max(net.stretch.x, lengthS);
  double stretchR = max(net.stretch.y, lengthR);
  double spread = stretchS * lengthR + lengthS * stretchR;
  double few = net.roundings + net.additions + 24.0LF;
  double edge = abs(line.edge);
  double growth = line.growth * line.growth * abs(weight);
  double ofNormal = edge * (smRoundingsOfNormal(net, spread, lengthS, lengthR) + few * normal) +
    line.trimRounding * stretchS * stretchR;
  double ofPoint = (net.roundings + 2.0LF) * net.radius + 2.0LF * size + net.off;
  double ofPosition = edge * normal * ofPoint;
  double square = size * size;
  at.noise = growth * inverse *
    dvec4(ofNormal, size * ofNormal + ofPosition, square * ofNormal + 2.0LF * size * ofPosition,
      square * size * ofNormal + 3.0LF * square * ofPosition);

  // Area: the normal's direction is off by at most 2 and by twice its relative error.
  dvec3 direction = dvec3(0.0LF);
  double offNormal = smRoundingsOfNormal(net, spread, lengthS, lengthR) + 4.0LF * normal;
  double offDirection = 18014398509481984.0LF; // 2 / u
  if (normal > 0.0LF)
  {
    direction = n / normal;
    offDirection = min(offDirection, 2.0LF * offNormal / normal);
  }
  dvec3 a = cross(sr, direction);
  dvec3 b = cross(direction, ss);
  at.alongS = dvec4(a, dot(at.position, a));
  at.alongR = dvec4(b, dot(at.position, b));
  at.area = -(hs.w * at.alongS + hr.w * at.alongR) * inverse;
  at.area.w += 2.0LF * normal;
  at.area *= coverage;
  at.alongS *= coverage;
  at.alongR *= coverage;
  // The sums of |R_s| and of |R_r| over all control points; roundings of each and of the tangents, and the
  // normal's direction.
  double slopeS = (2.0LF * net.degrees.x + abs(hs.w) * inverse) * inverse;
  double slopeR = (2.0LF * net.degrees.y + abs(hr.w) * inverse) * inverse;
  double steps = slopeS * stretchR + slopeR * stretchS;
  double turned = slopeS * lengthR + slopeR * lengthS;
  double ofArea = edge *
      (few * steps + turned * offDirection + slopeS * net.offSlope.y + slopeR * net.offSlope.x) +
    line.trimRounding * steps;
  at.areaNoise = growth *
    dvec2(ofArea,
      size * ofArea + edge * (turned * ofPoint + 2.0LF * inverse * (offNormal + few * normal)) +
        2.0LF * inverse * line.trimRounding * stretchS * stretchR);
  return at;
}
