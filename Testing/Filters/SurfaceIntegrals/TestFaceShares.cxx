// Faces shared among ranks, here threads of one process: the bits of a run alone, whoever fails; what
// travels, bit for bit; and who gets what.
#include "Items/smCPUItemRunner.h"
#include "Sharing/smFaceExchange.h"
#include "Sharing/smFaceShares.h"
#include "Sharing/smIntegralBytes.h"
#include "smFaceBytes.h"
#include "smSurfaceIntegrator.h"
#include "smTesting.h"

#include <algorithm>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

namespace
{
using namespace smtest;

std::shared_ptr<sm::Edge> MakeEdge(const std::array<double, 3>& from, const std::array<double, 3>& to)
{
  auto edge = std::make_shared<sm::Edge>();
  edge->Id = sm::NewId();
  edge->FileId = static_cast<int>(100 + edge->Id);
  edge->Name = "edge";
  edge->StartVertex = from;
  edge->EndVertex = to;
  edge->Tolerance = 1e-7;
  // Not on the faces, so that there are ribbons and gaps.
  const std::array<double, 3> points[3] = { from, { 0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1]), 0.05 },
    to };
  edge->Curve.Breaks = { 0.0 };
  edge->Curve.AppendPiece(1.0, points, 2);
  edge->Curve.Residual = { 1e-9, 2e-9, 3e-9 };
  return edge;
}

/// A strip of squares with bumps, cells x cells spans the first one and fewer the others, that share their
/// edges.
std::vector<sm::FacePointer> MakeStrip(int count, int cells)
{
  std::vector<sm::FacePointer> faces;
  auto left = MakeEdge({ 0, 0, 0 }, { 0, 1, 0 });
  for (int k = 0; k < count; ++k)
  {
    auto face = std::make_shared<sm::Face>();
    face->Id = sm::NewId();
    face->FileId = 10 + k;
    face->Name = "face " + std::to_string(k);
    face->Reversed = k % 2 == 1;
    sm::NURBSSurface& surface = face->Surface;
    const int spans = std::max(1, cells - k);
    for (int d = 0; d < 2; ++d)
    {
      surface.Degree[d] = 2;
      surface.NumberOfControlPoints[d] = spans + 2;
      surface.Knots[d] = { 0.0, 0.0, 0.0 };
      for (int i = 1; i < spans; ++i)
      {
        surface.Knots[d].push_back(static_cast<double>(i) / spans);
      }
      surface.Knots[d].insert(surface.Knots[d].end(), 3, 1.0);
    }
    surface.Rational = true;
    surface.Residual = 1e-9 * k;
    surface.Rounding = { 1e-10, 2e-10 * k, 0.0 };
    const auto greville = [&surface](int i)
    { return 0.5 * (surface.Knots[0][i + 1] + surface.Knots[0][i + 2]); };
    for (int j = 0; j < spans + 2; ++j)
    {
      for (int i = 0; i < spans + 2; ++i)
      {
        const bool isBorder = i == 0 || j == 0 || i == spans + 1 || j == spans + 1;
        const double w = isBorder ? 1.0 : 1.0 + 0.3 / (1.0 + i + 2 * j + k);
        const double z = isBorder ? 0.0 : 0.2 * std::sin(1.0 + 3.0 * i + 5.0 * j + k);
        surface.ControlPoints.push_back({ w * (k + greville(i)), w * greville(j), w * z, w });
      }
    }
    const double x = k;
    auto right = MakeEdge({ x + 1, 0, 0 }, { x + 1, 1, 0 });
    const std::shared_ptr<sm::Edge> edges[4] = { MakeEdge({ x, 0, 0 }, { x + 1, 0, 0 }), right,
      MakeEdge({ x, 1, 0 }, { x + 1, 1, 0 }), left };
    const std::array<double, 2> lines[4][2] = { { { 0, 0 }, { 1, 0 } }, { { 1, 0 }, { 1, 1 } },
      { { 0, 1 }, { 1, 1 } }, { { 0, 0 }, { 0, 1 } } };
    face->Loops.resize(1);
    for (int e = 0; e < 4; ++e)
    {
      sm::Coedge coedge;
      coedge.Use = edges[e];
      coedge.Reversed = e >= 2;
      coedge.Curve.Breaks = { 0.0 };
      coedge.Curve.AppendPiece(1.0, lines[e], 1);
      coedge.Curve.Residual = { 1e-10, 2e-10 };
      face->Loops[0].Coedges.push_back(coedge);
    }
    left = right;
    faces.push_back(face);
  }
  return faces;
}

std::vector<sm::FaceTask> MakeTasks(const std::vector<sm::FacePointer>& faces, double tolerance)
{
  std::vector<sm::FaceTask> tasks;
  for (const sm::FacePointer& face : faces)
  {
    tasks.push_back({ face, nullptr, { tolerance, tolerance }, {} });
  }
  return tasks;
}

/// Exchange between threads: all give, then all take, then the next round begins.
class Table
{
public:
  explicit Table(int ranks)
    : Given(ranks)
  {
  }
  std::vector<sm::Bytes> Meet(int rank, const sm::Bytes& mine)
  {
    std::unique_lock<std::mutex> lock(this->Lock);
    this->Changed.wait(lock, [this]() { return !this->Taking; });
    this->Given[rank] = mine;
    this->Taking = ++this->Present == static_cast<int>(this->Given.size());
    this->Changed.notify_all();
    this->Changed.wait(lock, [this]() { return this->Taking; });
    std::vector<sm::Bytes> all = this->Given;
    this->Taking = --this->Present > 0;
    this->Changed.notify_all();
    return all;
  }
  int GetNumberOfRanks() const { return static_cast<int>(this->Given.size()); }

private:
  std::mutex Lock;
  std::condition_variable Changed;
  std::vector<sm::Bytes> Given;
  int Present = 0;
  bool Taking = false;
};

class ThreadExchange : public sm::FaceExchange
{
public:
  ThreadExchange(Table& table, int rank)
    : Meeting(table)
    , Rank(rank)
  {
  }
  int GetNumberOfRanks() const override { return this->Meeting.GetNumberOfRanks(); }
  int GetRank() const override { return this->Rank; }
  bool Sum(sm::RankNumbers& numbers) override
  {
    sm::ByteWriter to;
    to.Put(numbers);
    numbers.fill(0.0);
    for (const sm::Bytes& given : this->Meeting.Meet(this->Rank, to.GetBytes()))
    {
      const auto theirs = sm::ByteReader(given).Get<sm::RankNumbers>();
      for (std::size_t i = 0; i < numbers.size(); ++i)
      {
        numbers[i] += theirs[i];
      }
    }
    return true;
  }
  bool Gather(int root, const sm::Bytes& mine, std::vector<sm::Bytes>& all) override
  {
    std::vector<sm::Bytes> given = this->Meeting.Meet(this->Rank, mine);
    if (this->Rank == root)
    {
      all = std::move(given);
    }
    return true;
  }
  bool Scatter(int root, const std::vector<sm::Bytes>& all, sm::Bytes& mine) override
  {
    sm::ByteWriter to;
    for (int rank = 0; rank < this->GetNumberOfRanks() && this->Rank == root; ++rank)
    {
      to.PutAll(all[rank]);
    }
    const std::vector<sm::Bytes> given = this->Meeting.Meet(this->Rank, to.GetBytes());
    sm::ByteReader from(given[root]);
    for (int rank = 0; rank <= this->Rank; ++rank)
    {
      mine = from.GetAll<char>();
    }
    return true;
  }

private:
  Table& Meeting;
  int Rank;
};

/// Fails where the test wants it.
class WeakRunner : public sm::CPUItemRunner
{
public:
  explicit WeakRunner(const std::string& failsIn)
    : FailsIn(failsIn)
  {
  }
  bool Acquire(const std::vector<sm::CutFacePointer>& faces, const sm::ProgressCallback& progress) override
  {
    return this->FailsIn == "acquiring" ? this->Fail("no room")
                                        : this->CPUItemRunner::Acquire(faces, progress);
  }
  bool BeginRows(std::size_t rows) override
  {
    return this->FailsIn == "running" ? this->Fail("no rows") : this->CPUItemRunner::BeginRows(rows);
  }

private:
  std::string FailsIn;
};

std::unique_ptr<sm::SurfaceIntegrator> MakeIntegrator(const std::string& failsIn)
{
  auto integrator = std::make_unique<sm::SurfaceIntegrator>();
  integrator->SetRunner(std::make_unique<WeakRunner>(failsIn));
  integrator->SetIntegrands(
    { sm::Integrand::VolumeMoment("V", 1, 0, 0), sm::Integrand::AreaMoment("A", 0, 0, 0) });
  return integrator;
}

using Results = std::vector<sm::FaceIntegrals>;

struct Team
{
  std::vector<std::unique_ptr<sm::SurfaceIntegrator>> Members;
  explicit Team(int ranks)
  {
    for (int rank = 0; rank < ranks; ++rank)
    {
      this->Members.push_back(MakeIntegrator(""));
    }
  }
  /// A run of all; the first has the faces.
  bool Integrate(const std::vector<sm::FaceTask>& tasks, Results& results)
  {
    Table table(static_cast<int>(this->Members.size()));
    std::vector<std::thread> threads;
    bool done = false;
    for (std::size_t rank = 0; rank < this->Members.size(); ++rank)
    {
      threads.emplace_back(
        [&, rank]()
        {
          ThreadExchange exchange(table, static_cast<int>(rank));
          sm::SurfaceIntegrator& integrator = *this->Members[rank];
          integrator.SetDevice({ "cpu", "thread", "", "", nullptr });
          integrator.BeginSharing(exchange, 0);
          if (rank == 0)
          {
            done = integrator.Integrate(tasks, results, nullptr);
          }
          else
          {
            integrator.RunAsWorker(nullptr);
          }
          integrator.FinishSharing("");
        });
    }
    std::for_each(threads.begin(), threads.end(), [](std::thread& thread) { thread.join(); });
    return done;
  }
};

sm::Bytes GetBytes(const Results& results)
{
  sm::ByteWriter to;
  for (const sm::FaceIntegrals& result : results)
  {
    sm::PutIntegrals(to, result);
  }
  return to.GetBytes();
}

void CheckRun(const std::string& what, Team& team, const std::vector<sm::FaceTask>& tasks,
  const Results& expected, const std::string& trouble)
{
  Results results;
  CheckTrue(what + ": integrated", team.Integrate(tasks, results), team.Members[0]->GetError());
  CheckTrue(what + ": the same bits", GetBytes(results) == GetBytes(expected));
  const std::vector<sm::RankReport>& ranks = team.Members[0]->GetRanks();
  CheckEqual(what + ": trouble of rank 1", trouble, ranks[1].FailureReason);
  std::size_t faces = 0;
  for (const sm::RankReport& report : ranks)
  {
    faces += report.Faces;
    CheckTrue(
      what + ": took part", report.Faces > 0 || !report.FailureReason.empty(), std::to_string(report.Faces));
  }
  CheckTrue(what + ": faces counted once", faces == tasks.size() || (!trouble.empty() && ranks[1].Faces == 0),
    std::to_string(faces));
}

void TestRanks()
{
  const std::vector<sm::FacePointer> faces = MakeStrip(12, 4);
  for (const double tolerance : { 1e-12, 1e-6 })
  {
    for (const std::int64_t budget : { std::int64_t{ 2000000000 }, std::int64_t{ 2000 } })
    {
      const std::string label = budget > 2000 ? "" : ", few evaluations";
      const std::vector<sm::FaceTask> tasks = MakeTasks(faces, tolerance);
      const auto alone = MakeIntegrator("");
      alone->SetMaximumEvaluations(budget);
      Results expected;
      CheckTrue("alone", alone->Integrate(tasks, expected, nullptr), alone->GetError());
      CheckTrue("something was integrated",
        expected[0].Face[1] > 0.9 && expected[0].Closing[0] != 0.0 && expected[0].Gaps.size() == 4,
        std::to_string(expected[0].Face[1]));
      for (const std::string failsIn : { "", "acquiring", "running" })
      {
        Team team(3);
        team.Members[1] = MakeIntegrator(failsIn);
        // The others have that of the rank with the faces.
        team.Members[0]->SetMaximumEvaluations(budget);
        CheckRun("fails in: " + failsIn + label, team, tasks, expected,
          failsIn.empty()          ? ""
            : failsIn == "running" ? "no rows"
                                   : "no room");
        CheckTrue("loosened" + label, team.Members[0]->WasLoosened() == alone->WasLoosened());
        if (failsIn.empty())
        {
          CheckEqual("evaluations" + label, alone->GetEvaluations(), team.Members[0]->GetEvaluations());
        }
        // Well again, and nothing is remembered that is not there.
        team.Members[1]->SetRunner(std::make_unique<sm::CPUItemRunner>());
        CheckRun("again after: " + failsIn + label, team, tasks, expected, "");
      }
    }
  }
  Team team(2);
  const std::vector<sm::FaceTask> tasks = MakeTasks(faces, 1e-9);
  Results expected;
  MakeIntegrator("")->Integrate(tasks, expected, nullptr);
  CheckRun("two", team, tasks, expected, "");
  CheckRun("two, known", team, tasks, expected, "");
  CheckEqual("nothing is evaluated twice", 0, team.Members[0]->GetEvaluations());
  team.Members[1] = MakeIntegrator("");
  CheckRun("one has lost its faces, and is sent them again", team, tasks, expected, "");
  // The budget removes the faces of all ranks, which are in one process here, while they do not run.
  sm::CacheBudget& budget = sm::CacheBudget::GetProcessBudget();
  const std::size_t limit = budget.GetLimit();
  budget.SetLimit(1);
  CheckEqual("bytes kept in spite of the budget", 0LL, static_cast<long long>(budget.GetBytes()));
  budget.SetLimit(limit);
  CheckRun("the budget removed faces, which are sent again", team, tasks, expected, "");
  team.Members[1]->SetPerturbation(2.0);
  CheckRun("one computes something else", team, tasks, expected, "its integrands are not the same");
}

sm::Bytes GetBytes(const sm::Face& face)
{
  sm::ByteWriter to;
  sm::FaceWriter(to).Put(face);
  return to.GetBytes();
}

void TestBytes()
{
  const std::vector<sm::FacePointer> faces = MakeStrip(3, 3);
  sm::ByteWriter to;
  sm::FaceWriter writer(to);
  std::size_t apart = 0;
  for (const sm::FacePointer& face : faces)
  {
    writer.Put(*face);
    apart += GetBytes(*face).size();
  }
  CheckTrue("shared edges travel once", to.GetBytes().size() < apart,
    std::to_string(to.GetBytes().size()) + " of " + std::to_string(apart));
  sm::ByteReader from(to.GetBytes());
  sm::FaceReader reader(from);
  std::vector<sm::FacePointer> received;
  for (const sm::FacePointer& face : faces)
  {
    received.push_back(reader.Get());
    CheckTrue("bit for bit", received.back() && GetBytes(*received.back()) == GetBytes(*face));
    CheckTrue("an id of its own", received.back()->Id != face->Id);
  }
  CheckTrue(
    "edges are shared again", received[0]->Loops[0].Coedges[1].Use == received[1]->Loops[0].Coedges[3].Use);
  int complete = 0;
  for (std::size_t size = 0; size < to.GetBytes().size(); size += 3)
  {
    const sm::Bytes part(to.GetBytes().begin(), to.GetBytes().begin() + static_cast<std::ptrdiff_t>(size));
    sm::ByteReader fromPart(part);
    sm::FaceReader partReader(fromPart);
    complete += partReader.Get() && partReader.Get() && partReader.Get() ? 1 : 0;
  }
  CheckEqual("messages that end early are not faces", 0, complete);
}

void TestDivision()
{
  const std::vector<sm::FacePointer> faces = MakeStrip(40, 6);
  const std::vector<sm::FaceTask> tasks = MakeTasks(faces, 1e-9);
  sm::FaceShares shares;
  const std::vector<bool> fit = { true, true, false, true };
  const std::vector<int> ranks = shares.Divide(tasks, fit);
  std::vector<double> loads(fit.size(), 0.0);
  double total = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < tasks.size(); ++i)
  {
    const double cost = sm::EstimateCost(*faces[i]);
    loads[ranks[i]] += cost;
    total += cost;
    largest = std::max(largest, cost);
  }
  Check("nothing for a rank that is not fit", 0.0, loads[2], 0.0);
  for (const int rank : { 0, 1, 3 })
  {
    CheckRange("load of a rank", total / 3.0 - largest, loads[rank], total / 3.0 + largest, "longest first");
  }
  shares.EndRun();
  // An edit: one face is another, the others stay where they are.
  std::vector<sm::FaceTask> edited = tasks;
  edited[7].Source = MakeStrip(1, 5)[0];
  std::vector<int> after = shares.Divide(edited, fit);
  after[7] = ranks[7];
  CheckTrue("faces stay", after == ranks);
  // A result is sent to a rank once, and dropped in time when it is not requested.
  std::vector<std::size_t> own;
  for (std::size_t i = 0; i < tasks.size(); ++i)
  {
    if (ranks[i] == 1)
    {
      own.push_back(i);
    }
  }
  sm::ReceivedFaces received;
  std::size_t sizes[2];
  for (std::size_t& size : sizes)
  {
    sm::ByteWriter to;
    shares.Divide(tasks, fit);
    shares.Pack(tasks, own, to);
    size = to.GetBytes().size();
    sm::ByteReader from(to.GetBytes());
    std::vector<sm::FaceTask> there;
    CheckTrue("arrived", received.Unpack(0, from, there) && there.size() == own.size());
    shares.EndRun();
  }
  CheckTrue("the second time less travels", sizes[1] * 5 < sizes[0],
    std::to_string(sizes[1]) + " after " + std::to_string(sizes[0]));
  for (int run = 0; run < 20; ++run)
  {
    sm::ByteWriter to;
    shares.Divide({ tasks[own[0]] }, fit);
    shares.Pack(tasks, { own[0] }, to);
    sm::ByteReader from(to.GetBytes());
    std::vector<sm::FaceTask> there;
    received.Unpack(0, from, there);
    shares.EndRun();
  }
  CheckEqual("faces kept", 1, static_cast<long long>(received.GetNumberOfFaces()));
  CheckTrue("in its session", received.FindSession(0) == shares.GetSession() && shares.GetSession() != 0);
  CheckEqual("which is that of one sender", 0LL, static_cast<long long>(received.FindSession(2)));
}
}

int TestFaceShares(int, char*[])
{
  TestBytes();
  TestDivision();
  TestRanks();
  return Finish();
}
