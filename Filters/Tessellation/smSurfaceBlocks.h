/**
 * @file smSurfaceBlocks.h
 * @brief Bounds of a surface's second derivatives, block by block, and what they say about triangles
 *
 * A triangle whose corners lie on the surface, with parameters in a box of widths W_u, W_v, is nowhere
 * farther from the point of the surface with the same barycentric parameters than
 *
 *     (M_uu W_u^2 + 2 M_uv W_u W_v + M_vv W_v^2) / 8  +  sum over creases J W / 4,
 *
 * M: bounds of the second derivatives on the box, J: jump of the first derivative across a crease that the
 * box straddles, in the direction of W. For Taylor's formula at the point gives sum lambda_i D^2 S (p_i -
 * x)^2 / 2 with the barycentric coordinates lambda_i; sum lambda_i (u_i - u)^2 is a variance of numbers in an
 * interval of width W_u, at most W_u^2 / 4, and so on; the part of a mean absolute deviation on one side is
 * at most W_u / 4.
 *
 * Most of that error may lie in the surface, where parameters run unevenly. Let n be a unit vector from which
 * no normal on the box is farther than the angle theta, below 90 degrees: then the part of the surface on the
 * box has slopes of at most tan(theta) over the plane across n. From the point of the surface with the same
 * barycentric parameters one follows the surface across n as far as the triangle's point lies: its distance
 * is at most the error along n plus tan(theta) times the error across n. So M may be the second derivatives
 * along n plus tan(theta) M; and J becomes J / cos(theta), the maximum of |x.n| + tan(theta) |x - (x.n) n|
 * for vectors x of length J. The smaller of both sums is taken. On a box in several blocks n and theta are
 * the same for all of them.
 *
 * That form bounds the distance across the surface. Where one leaves the part on the box before the
 * triangle's point is reached, the surface is thought of as continued with slopes of at most tan(theta): a
 * triangle may reach sideways beyond that part, at most by the whole error.
 *
 * Between two points of the box S_u differs by at most M_uu W_u + M_uv W_v plus the jumps J of the creases
 * between them, S_v likewise; and so do their components along a unit vector. What that says about normals is
 * in smTriangleJudge.h.
 */
#ifndef smSurfaceBlocks_h
#define smSurfaceBlocks_h

#include "smFiltersTessellationModule.h"

#include "smMeshLimits.h"
#include "smNURBSSurface.h"
#include "smVector.h"

#include <algorithm>
#include <array>
#include <vector>

namespace sm
{
struct BernsteinNet;

struct ParameterBox
{
  std::array<double, 2> Low{};
  std::array<double, 2> High{};
  void Add(const std::array<double, 2>& uv)
  {
    for (int d = 0; d < 2; ++d)
    {
      this->Low[d] = std::min(this->Low[d], uv[d]);
      this->High[d] = std::max(this->High[d], uv[d]);
    }
  }
};

class SMFILTERSTESSELLATION_EXPORT SurfaceBlocks
{
public:
  struct Block
  {
    /// Bounds of |S_uu|, |S_uv| and |S_vv|, less what lies in the surface.
    double Uu = 0.0;
    double Uv = 0.0;
    double Vv = 0.0;
    /// About the turn of the normal per unit of u and v, in radians, and |S_u| and |S_v|.
    std::array<double, 2> Turn{};
    std::array<double, 2> Speed{};
    /// Bounds of |S_uu|, |S_uv| and |S_vv|, and of their components along Normal; no normal of the block is
    /// farther from that than Tilt, in radians.
    std::array<double, 3> Full{};
    std::array<double, 3> Along{};
    std::array<double, 3> Normal{};
    double Tilt = 4.0;
    /// Factor of a jump of the first derivative in Uu, Uv and Vv: 1 / cos of the tilt where they are those
    /// along Normal, else 1.
    double JumpFactor = 1.0;
    /// Rounding of the derivatives S_u and S_v as they are evaluated.
    std::array<double, 2> Rounding{};
    /// Sets Uu, Uv, Vv for normals within `tilt` of Normal.
    void Choose(double tilt);
  };

  /// For parameters in `covered`, which may reach a little beyond the surface's domain. Several blocks to a
  /// span where it is curved. With a deflection, bounds are sharp only where that changes a mesh within the
  /// limits.
  SurfaceBlocks(const NURBSSurface& surface, const ParameterBox& covered, const MeshLimits& limits = {});

  /// Error of any triangle by jumps of derivatives that are rounding, or little more; they are not creases.
  double GetSmallJumps() const;

  /// The bound above, without GetSmallJumps().
  double GetError(const ParameterBox& box) const;
  /// Bounds of the differences of S_u and of S_v between points of the box that are no farther from each
  /// other than this share of its widths, and of their components along `normal`, a unit vector; with their
  /// rounding.
  struct DerivativeChanges
  {
    std::array<double, 2> Full{};
    std::array<double, 2> Along{};
  };
  DerivativeChanges GetDerivativeChanges(const ParameterBox& box, double share, const Vector3& normal) const;
  /// The largest of all blocks that the box touches.
  Block GetLargest(const ParameterBox& box) const;
  /// Returns true where GetError() of every box and the turn of the normal across all are negligible compared
  /// with the deflection and the angle.
  bool IsFlat(double deflection, double angle) const;

  const ParameterBox& GetCovered() const { return this->Covered; }
  /// Borders of the blocks in direction d.
  const std::vector<double>& GetBreaks(int d) const { return this->Breaks[d]; }
  const Block& GetBlock(std::size_t i, std::size_t j) const
  {
    return this->Blocks[i + j * (this->Breaks[0].size() - 1)];
  }

private:
  /// A line of constant parameter across which the first derivative jumps by at most Jump.
  struct Crease
  {
    double At;
    double Jump;
    /// Half the width of a thin strip that it stands for, in which the derivative changes by Jump; 0: none.
    double Half;
  };
  /// Spans of the surface in direction d and, in Breaks, the borders of the blocks; returns how many there
  /// are in a span.
  int ListBreaks(const NURBSSurface& surface, int d, std::vector<double>& spans);
  /// Bounds on the block `at`, a part of the patch that begins at `low`.
  void MeasureBlock(const BernsteinNet& net, const std::array<double, 2>& low,
    const std::array<double, 2>& width, const std::array<std::size_t, 2>& at, bool rational,
    const MeshLimits& limits);
  static void AddCrease(double at, double jump, std::vector<Crease>& creases);
  void CountThinStrips(int direction);
  void GetRange(const ParameterBox& box, int d, std::size_t& first, std::size_t& last) const;
  /// The block that holds the box; null: several do.
  const Block* FindSingle(const ParameterBox& box) const;

  ParameterBox Covered;
  std::vector<double> Breaks[2];
  std::vector<Block> Blocks;
  std::vector<Crease> Creases[2];
  std::vector<Crease> SmallJumps[2];
};
}

#endif
