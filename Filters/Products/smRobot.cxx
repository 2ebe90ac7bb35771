#include "smRobot.h"

#include "smFormat.h"
#include "smLengthUnits.h"
#include "smMaterials.h"
#include "smProductResults.h"
#include "smProducts.h"
#include "smTrimText.h"
#include "smVector.h"

#include "vtkMath.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <system_error>
#include <utility>

namespace sm
{
namespace
{
using Matrix3 = std::array<double, 9>;
using Pose = std::array<double, 12>;
constexpr Pose IdentityPose{ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0 };
/// Readers' limits, see CheckRobot().
constexpr double MinSdfMass = 1e-6;
constexpr double MinMujocoMoment = 1e-14;
constexpr double TriangleRounding = 1e-15;

/// Returns R^T (p - t) of a pose.
std::array<double, 3> ToLocal(const Pose& pose, const std::array<double, 3>& p)
{
  std::array<double, 3> result{};
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      result[i] += pose[4 * k + i] * (p[k] - pose[4 * k + 3]);
    }
  }
  return result;
}

std::array<double, 3> RotateToLocal(const Pose& pose, const std::array<double, 3>& v)
{
  Pose rotation = pose;
  rotation[3] = rotation[7] = rotation[11] = 0.0;
  return ToLocal(rotation, v);
}

/// Returns R^T I R.
Matrix3 RotateToLocal(const Pose& pose, const Matrix3& tensor)
{
  Matrix3 result{};
  for (int i = 0; i < 3; ++i)
  {
    for (int j = i; j < 3; ++j)
    {
      double sum = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        for (int l = 0; l < 3; ++l)
        {
          sum += pose[4 * k + i] * tensor[3 * k + l] * pose[4 * l + j];
        }
      }
      result[3 * i + j] = result[3 * j + i] = sum;
    }
  }
  return result;
}

bool IsRigid(const double* placement)
{
  double determinant[3][3];
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      determinant[i][j] = placement[4 * i + j];
    }
  }
  return std::abs(vtkMath::Determinant3x3(determinant) - 1.0) < 1e-9;
}

std::string LowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Length of a name of a link without the number that makes it unique: names of files have at most 255 bytes.
constexpr std::size_t MaxLinkName = 100;

/// Letters and digits of names of links and files.
std::string Simplify(const std::string& name)
{
  std::string result;
  for (const char c : name)
  {
    const auto u = static_cast<unsigned char>(c);
    const bool isPlain = u < 128 && (std::isalnum(u) != 0 || c == '_' || c == '-' || c == '.');
    result += isPlain ? c : '_';
  }
  // SDF reserves names with two underscores at both ends, and readers the name of the frame of the world.
  return result.empty() || result == "world" || result.rfind("__", 0) == 0 ? "link_" + result : result;
}

class RobotMaker
{
public:
  RobotMaker(const ProductResults& results, const std::vector<std::string>& fused,
    const std::vector<RobotJoint>& joints, const std::vector<double>& frame, Robot& robot)
    : Results(results)
    , Fused(fused)
    , Joints(joints)
    , Result(robot)
    , HasFrame(frame.size() == 9)
    , Metres(GetMetres(results.LengthUnit.value_or("")))
  {
    if (this->HasFrame)
    {
      const std::array<double, 3> z = Normalized<double>({ frame[3], frame[4], frame[5] });
      const std::array<double, 3> y = Normalized(Cross(z, { frame[6], frame[7], frame[8] }));
      const std::array<double, 3> axes[3] = { Cross(y, z), y, z };
      for (int i = 0; i < 3; ++i)
      {
        for (int j = 0; j < 3; ++j)
        {
          this->Frame[4 * i + j] = axes[j][i];
        }
        this->Frame[4 * i + 3] = this->Metres * frame[i];
      }
    }
  }

  void Make(const ProductTreeNode& tree)
  {
    if (!(this->Metres > 0.0))
    {
      this->Result.Problem = "its length unit is not known";
      return;
    }
    this->AddNode(tree);
    this->AddJoints();
    for (std::size_t i = 0; i < this->Result.Links.size(); ++i)
    {
      this->Weigh(this->Solids[i], this->Result.Links[i]);
    }
    if (this->HasFrame && !this->IsFrameUsed)
    {
      this->Result.Messages.push_back("no link has the frame of --about: a link has that of its product, "
                                      "unless --fuse names it");
    }
    if (this->Result.Problem.empty() && this->Result.Links.empty())
    {
      this->Result.Problem = "no solid has a mass and an inertia: give the densities that are missing, see "
                             "--density and --materials";
    }
  }

private:
  const SolidResults* FindSolid(const std::string& id) const
  {
    const auto found = std::find_if(this->Results.Solids.begin(), this->Results.Solids.end(),
      [&id](const SolidResults& solid) { return solid.Id == id; });
    return found == this->Results.Solids.end() || !found->Values.Volume.IsKnown() ? nullptr : &*found;
  }

  static void ListBelow(const ProductTreeNode& node, std::vector<ProductTreeNode::Body>& bodies)
  {
    bodies.insert(bodies.end(), node.Bodies.begin(), node.Bodies.end());
    for (const ProductTreeNode& child : node.Children)
    {
      ListBelow(child, bodies);
    }
  }

  void AddNode(const ProductTreeNode& node)
  {
    const bool isFused = std::any_of(this->Fused.begin(), this->Fused.end(),
      [&node](const std::string& pattern) { return MatchesPattern(pattern, node.Name); });
    std::vector<ProductTreeNode::Body> bodies = node.Bodies;
    if (isFused)
    {
      bodies.clear();
      ListBelow(node, bodies);
    }
    this->AddLink(node, bodies, isFused);
    for (const ProductTreeNode& child : node.Children)
    {
      if (!isFused)
      {
        this->AddNode(child);
      }
    }
  }

  /// Returns a name that no other link has, nor a mesh or a joint of one; also without regard to case, as
  /// names of files on some systems.
  std::string MakeUnique(const std::string& name)
  {
    const std::string plain = Simplify(name).substr(0, MaxLinkName);
    for (int& i = this->Last[LowerCase(plain)];;)
    {
      ++i;
      const std::string unique = i == 1 ? plain : plain + "-" + std::to_string(i);
      std::vector<std::string> own;
      for (const char* const ending : { "", "-hull", "_hull", "_joint" })
      {
        own.push_back(LowerCase(unique) + ending);
      }
      if (std::none_of(
            own.begin(), own.end(), [this](const std::string& text) { return this->Taken.count(text) > 0; }))
      {
        this->Taken.insert(own.begin(), own.end());
        return unique;
      }
    }
  }

  void AddLink(const ProductTreeNode& node, const std::vector<ProductTreeNode::Body>& bodies, bool isFused)
  {
    const std::string& product = node.Name;
    std::vector<const SolidResults*> solids;
    RobotLink link;
    const double* placement = node.Placement ? node.Placement->data() : nullptr;
    for (const ProductTreeNode::Body& body : bodies)
    {
      if (const SolidResults* solid = this->FindSolid(body.Id))
      {
        solids.push_back(solid);
        link.Bodies.push_back(body.Id);
        placement = placement ? placement : body.Placement;
      }
    }
    if (solids.empty())
    {
      return;
    }
    link.Product = product;
    link.Name = this->MakeUnique(product.empty() ? this->Result.Name : product);
    link.Pose = this->Frame;
    if (!isFused && placement && IsRigid(placement))
    {
      std::copy_n(placement, 12, link.Pose.begin());
      for (const int i : { 3, 7, 11 })
      {
        link.Pose[i] *= this->Metres;
      }
    }
    else
    {
      this->IsFrameUsed = true;
    }
    if (!HasMass(solids))
    {
      this->Result.Messages.push_back("the link " + link.Name +
        " is left out: its mass or inertia is not known; give its density, see --density and --materials");
      ++this->Result.Missing;
      return;
    }
    this->Result.Links.push_back(link);
    this->Solids.push_back(solids);
  }

  static bool HasMass(const std::vector<const SolidResults*>& solids)
  {
    return std::all_of(solids.begin(), solids.end(),
      [](const SolidResults* solid)
      {
        const Quantities& q = solid->Values;
        return q.Mass.Get() > 0.0 && q.MassCenter.IsKnown() && q.MassInertia.IsKnown();
      });
  }

  /// Sums masses and tensors about the common centre, by Steiner's theorem.
  void Weigh(const std::vector<const SolidResults*>& solids, RobotLink& link) const
  {
    link.Mass = 0.0;
    std::array<double, 3> center{};
    for (const SolidResults* solid : solids)
    {
      link.Mass += solid->Values.Mass.Get();
    }
    for (const SolidResults* solid : solids)
    {
      const double share = solid->Values.Mass.Get() / link.Mass;
      for (int i = 0; i < 3; ++i)
      {
        center[i] += share * this->Metres * solid->Values.MassCenter.Value[i];
      }
    }
    Matrix3 tensor{};
    for (const SolidResults* solid : solids)
    {
      const Quantities& q = solid->Values;
      std::array<double, 3> d{};
      for (int i = 0; i < 3; ++i)
      {
        d[i] = solids.size() == 1 ? 0.0 : this->Metres * q.MassCenter.Value[i] - center[i];
      }
      for (int i = 0; i < 3; ++i)
      {
        for (int j = 0; j < 3; ++j)
        {
          tensor[3 * i + j] += this->Metres * this->Metres * q.MassInertia.Value[3 * i + j] +
            q.Mass.Get() * ((i == j ? Dot(d, d) : 0.0) - d[i] * d[j]);
        }
      }
    }
    link.Center = ToLocal(link.Pose, center);
    link.Inertia = RotateToLocal(link.Pose, tensor);
  }

  /// Returns the index of the link of this name, or of the only one of this product; -1 if there is none, -2
  /// if there are several.
  int FindLink(const std::string& name) const
  {
    int found = -1;
    for (std::size_t i = 0; i < this->Result.Links.size(); ++i)
    {
      const RobotLink& link = this->Result.Links[i];
      if (link.Name == name)
      {
        return static_cast<int>(i);
      }
      if (link.Product == name)
      {
        found = found == -1 ? static_cast<int>(i) : -2;
      }
    }
    return found;
  }

  /// Adds a message, once, if the name of a link is that of a product that is several links, too.
  void NoteFirst(int index, const std::string& name)
  {
    const std::vector<RobotLink>& links = this->Result.Links;
    const auto count = std::count_if(
      links.begin(), links.end(), [&name](const RobotLink& link) { return link.Product == name; });
    if (index >= 0 && links[index].Name == name && count > 1 && this->Noted.insert(name).second)
    {
      this->Result.Messages.push_back("the table of joints: " + name + " is one link, the first of " +
        std::to_string(count) + " of the product of that name");
    }
  }

  void Refuse(const std::string& problem)
  {
    this->Result.Problem = this->Result.Problem.empty() ? problem : this->Result.Problem;
  }

  void AddJoints()
  {
    std::vector<RobotLink>& links = this->Result.Links;
    std::vector<bool> isPlaced(links.size(), false);
    int root = 0;
    for (const RobotJoint& joint : this->Joints)
    {
      const std::string name = "the joint " + joint.Parent + " - " + joint.Child + ": ";
      const int child = this->FindLink(joint.Child);
      const int parent = joint.Parent == "world" ? -1 : this->FindLink(joint.Parent);
      for (const auto& [index, link] :
        { std::make_pair(child, joint.Child), std::make_pair(parent, joint.Parent) })
      {
        if (index == -2 || (index == -1 && link != "world"))
        {
          this->Refuse(name + (index == -2 ? "several links are of the product " : "there is no link ") +
            link + (index == -2 ? "; name one of them, as " : "; there are, for example, ") +
            this->ListLinks());
          return;
        }
      }
      if (child < 0 || isPlaced[child])
      {
        this->Refuse(
          name + (child < 0 ? "the world cannot be a child" : "its child has another joint already"));
        return;
      }
      for (const auto& [index, said] :
        { std::make_pair(child, joint.Child), std::make_pair(parent, joint.Parent) })
      {
        this->NoteFirst(index, said);
      }
      RobotLink& link = links[child];
      isPlaced[child] = true;
      for (int i = 0; i < 3 && joint.Origin; ++i)
      {
        link.Pose[4 * i + 3] = this->Metres * (*joint.Origin)[i];
      }
      link.Parent = parent;
      link.JointType = joint.Type;
      link.Axis = Normalized(RotateToLocal(link.Pose, joint.Axis));
      root = parent < 0 ? child : root;
    }
    while (root < static_cast<int>(links.size()) && isPlaced[root] && links[root].Parent >= 0)
    {
      ++root;
    }
    if (root == static_cast<int>(links.size()) && !links.empty())
    {
      this->Refuse("the joints form a circle: no link is the root");
      return;
    }
    for (int i = 0; i < static_cast<int>(links.size()); ++i)
    {
      links[i].Parent = i == root ? -1 : isPlaced[i] ? links[i].Parent : root;
    }
    for (int i = 0; i < static_cast<int>(links.size()); ++i)
    {
      int steps = 0;
      for (int k = i; k >= 0; k = links[k].Parent)
      {
        if (++steps > static_cast<int>(links.size()))
        {
          this->Refuse("the joints form a circle at the link " + links[i].Name);
          return;
        }
      }
    }
  }

  std::string ListLinks() const
  {
    std::string text;
    for (std::size_t i = 0; i < std::min<std::size_t>(this->Result.Links.size(), 5); ++i)
    {
      text += (i > 0 ? ", " : "") + this->Result.Links[i].Name;
    }
    return text;
  }

  const ProductResults& Results;
  const std::vector<std::string>& Fused;
  const std::vector<RobotJoint>& Joints;
  Robot& Result;
  bool HasFrame;
  bool IsFrameUsed = false;
  double Metres;
  /// Of links that are fused, and of mirrored ones.
  Pose Frame = IdentityPose;
  /// In lower case.
  std::set<std::string> Taken;
  /// The last number of each name.
  std::map<std::string, int> Last;
  std::set<std::string> Noted;
  /// Of each link.
  std::vector<std::vector<const SolidResults*>> Solids;
};

std::array<double, 3> GetPrincipalMoments(const Matrix3& tensor)
{
  double rows[3][3];
  double vectors[3][3];
  std::array<double, 3> moments;
  for (int i = 0; i < 9; ++i)
  {
    rows[i / 3][i % 3] = tensor[i];
  }
  double* a[3] = { rows[0], rows[1], rows[2] };
  double* v[3] = { vectors[0], vectors[1], vectors[2] };
  vtkMath::Jacobi(a, moments.data(), v);
  std::sort(moments.begin(), moments.end());
  return moments;
}

bool IsHeader(const std::vector<std::string>& fields)
{
  return fields.size() >= 3 && fields[0] == "parent" && fields[1] == "child" && fields[2] == "type";
}

/// Reads three numbers; returns false if a field is not a finite number.
bool ParseVector(const std::vector<std::string>& fields, std::size_t first, std::array<double, 3>& vector)
{
  for (int i = 0; i < 3; ++i)
  {
    const std::string& text = fields[first + i];
    // In every locale with a decimal point.
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), vector[i]);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(vector[i]))
    {
      return false;
    }
  }
  return true;
}
}

std::optional<RobotFormat> ParseRobotFormat(const std::string& name)
{
  return name == "urdf" ? std::optional(RobotFormat::Urdf)
    : name == "sdf"     ? std::optional(RobotFormat::Sdf)
    : name == "mjcf"    ? std::optional(RobotFormat::Mjcf)
                        : std::nullopt;
}

std::string ParseRobotJoints(const std::string& text, std::vector<RobotJoint>& joints)
{
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();)
  {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::vector<std::string> fields = SplitFields(text.substr(begin, end - begin));
    begin = end + 1;
    ++number;
    const bool isEmpty = fields.size() == 1 && fields[0].empty();
    const bool isRemark = !fields[0].empty() && fields[0][0] == '#';
    if (isEmpty || isRemark || IsHeader(fields))
    {
      continue;
    }
    const std::string place = "line " + std::to_string(number) + ": ";
    if (fields.size() != 3 && fields.size() != 6 && fields.size() != 9)
    {
      return place + "write PARENT,CHILD,TYPE, or with ,X,Y,Z of the axis, or with ,X,Y,Z of the origin, too";
    }
    if (fields[0].empty() || fields[1].empty())
    {
      return place + "the " + (fields[0].empty() ? "parent" : "child") +
        " is empty: write the name of a link, or world for the parent of the root";
    }
    RobotJoint joint;
    joint.Parent = fields[0];
    joint.Child = fields[1];
    joint.Type = fields[2];
    std::array<double, 3> origin{};
    if ((fields.size() > 3 && !ParseVector(fields, 3, joint.Axis)) ||
      (fields.size() > 6 && !ParseVector(fields, 6, origin)) || !(Norm(joint.Axis) > 0.0))
    {
      return place + "axis and origin are three numbers each, and the axis is not 0";
    }
    if (joint.Type != "fixed" && joint.Type != "revolute" && joint.Type != "prismatic")
    {
      return place + "there is no type " + joint.Type + "; use fixed, revolute or prismatic";
    }
    if (fields.size() > 6)
    {
      joint.Origin = origin;
    }
    joints.push_back(joint);
  }
  return {};
}

Robot MakeRobot(const std::string& name, const ProductTreeNode& tree, const ProductResults& results,
  const std::vector<std::string>& fused, const std::vector<RobotJoint>& joints,
  const std::vector<double>& frame)
{
  Robot robot;
  robot.Name = Simplify(name);
  RobotMaker(results, fused, joints, frame, robot).Make(tree);
  return robot;
}

void CheckRobot(Robot& robot, RobotFormat format)
{
  const auto note = [&robot](const RobotLink& link, const std::string& text)
  { robot.Messages.push_back("the link " + link.Name + ": " + text); };
  for (const RobotLink& link : robot.Links)
  {
    const std::array<double, 3> moments = GetPrincipalMoments(link.Inertia);
    if (link.Mass < MinSdfMass && format != RobotFormat::Mjcf)
    {
      note(link,
        "its mass is " + FormatDigits(link.Mass, 3) + " kg, and libsdformat leaves out links below 1e-6 kg");
    }
    if (moments[0] < MinMujocoMoment && format != RobotFormat::Sdf)
    {
      note(link,
        "its smallest moment is " + FormatDigits(moments[0], 3) +
          " kg m^2, and MuJoCo refuses moments below 1e-14 kg m^2");
    }
    if (moments[2] > (moments[0] + moments[1]) * (1.0 - TriangleRounding))
    {
      note(link,
        "its largest principal moment is the sum of the others, or more: rounding decides whether "
        "libsdformat and MuJoCo take it");
    }
  }
}
}
