package org.starl.apps.search.logic;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.geometry.Point;
import org.starl.gvh.GvhCell;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.Decision;
import org.starl.primitives.agreement.SetAgreement;
import org.starl.primitives.election.Election;
import org.starl.primitives.election.Leader;
import org.starl.primitives.geocast.Broadcast;
import org.starl.trace.Instance;

/**
 * One robot's part in the team: broadcasts once a second what the robot does and knows, leads while
 * it is elected, and brings about one answer by SetAgreement. Strand only.
 */
final class Team {

  private static final long NS_PER_MS = 1_000_000;
  private static final long PERIOD_NS = 1_000 * NS_PER_MS;
  private static final long TELL_MS = 950;
  private static final long LAST_REPORT_MS = 30_000;
  private static final long LEAD_PERIOD_NS = 500 * NS_PER_MS;

  private final GlobalVarHolder gvh;
  private final House house;
  private final Knowledge known;
  private final Election election;
  private final SetAgreement<Answer> agreement;
  private final Broadcast<Report> broadcast;
  private final ProcessId me;
  private final Integer[] tries;
  private final GvhCell<SearchFact.Assigned> duty;
  private final GvhCell<SearchFact.Rooms> swept;
  private @Nullable Assigner assigner;
  private int room = Report.NO_ROOM;
  private long reports;
  private long tellAtNs;
  private long leadAtNs;
  private long takenTerm;
  private int takenNumber;
  private boolean isProposing;

  Team(GlobalVarHolder gvh, String xid, House house) {
    this.gvh = gvh;
    this.house = house;
    known = new Knowledge(house);
    me = gvh.id.freshProcess();
    tries = new Integer[house.rooms().size()];
    Arrays.fill(tries, 0);
    duty = gvh.variable(SearchFact.DUTY, SearchFact.Assigned.NONE);
    swept = gvh.variable(SearchFact.SWEPT, new SearchFact.Rooms(List.of()));
    election = new Election(gvh, xid);
    agreement = new SetAgreement<>(gvh, xid, Answer.SHAPE);
    broadcast = new Broadcast<>(gvh, xid, Report.shape(tries.length), this::heard);
  }

  void begin() {
    election.do_election();
    agreement.refresh();
  }

  /** The robot's work for the team; to be called every period. */
  void work() {
    if (election.failed().get()) {
      election.do_election();
    }
    lead();
    if (gvh.plat.clock.nowNs() >= tellAtNs) {
      tell(TELL_MS);
    }
    Optional<Answer> answer = known.answer();
    if (answer.isPresent() && !isDecided() && (!isProposing || agreement.failed().get())) {
      isProposing = true;
      agreement.propose(answer.get());
    }
  }

  boolean hasLeader() {
    return election.Leader().get().isElected();
  }

  /** Whether the robots have agreed on an answer, as far as this one knows. */
  boolean isDecided() {
    return agreement.decided().get().isDecided();
  }

  /** The answer that the robots have agreed on; {@link #isDecided} must hold. */
  Answer decision() {
    if (agreement.decided().get() instanceof Decision.Decided<Answer> decided) {
      return decided.value();
    }
    throw new IllegalStateException("nothing is decided yet");
  }

  /** Whether this robot knows an answer, agreed on or not. */
  boolean hasAnswer() {
    return known.answer().isPresent();
  }

  void conclude(Answer answer) {
    known.conclude(answer);
    tellSoon();
  }

  /**
   * Takes the task that the leader has assigned to this robot, unless it has taken that one before.
   */
  Optional<Room> takeTask() {
    Report.Duty latest = known.duty().orElse(null);
    Report.Task task = latest == null ? null : latest.tasks().get(gvh.id.name());
    if (latest == null
        || task == null
        || known.swept().contains(task.room())
        || (latest.term() == takenTerm && task.number() <= takenNumber)) {
      return Optional.empty();
    }
    takenTerm = latest.term();
    takenNumber = task.number();
    room = task.room();
    tellSoon();
    return Optional.of(house.room(room));
  }

  boolean isSwept(Room which) {
    return known.swept().contains(which.index());
  }

  Knowledge known() {
    return known;
  }

  /** This robot has searched its room in full. */
  void sweptRoom() {
    known.addSwept(room);
    gvh.trace.action(Instance.APP, SearchFact.SHAPE, new SearchFact.Swept(name(room)));
    leaveRoom();
  }

  /** This robot could not enter its room or could not see all of it. */
  void failedRoom() {
    tries[room] = Math.min(Report.MAX_TRIES, tries[room] + 1);
    leaveRoom();
  }

  /** This robot has no room any more. */
  void leaveRoom() {
    room = Report.NO_ROOM;
    tellSoon();
  }

  /**
   * The robot's last report, sent for a while: a robot that has missed the decision hears of it.
   */
  void tellDecision() {
    known.conclude(decision());
    tell(LAST_REPORT_MS);
  }

  private void tellSoon() {
    tellAtNs = gvh.plat.clock.nowNs();
  }

  private void lead() {
    if (!election.isLeader() || !(election.Leader().get() instanceof Leader.Name name)) {
      assigner = null;
      duty.set(SearchFact.Assigned.NONE);
      return;
    }
    long nowNs = gvh.plat.clock.nowNs();
    if (assigner == null || assigner.term() != name.term()) {
      assigner = new Assigner(house, gvh.id.name(), gvh.id.participants(), name.term(), nowNs);
    }
    if (nowNs >= leadAtNs && !hasAnswer()) {
      leadAtNs = nowNs + LEAD_PERIOD_NS;
      known.hear(report());
      assigner.work(known, nowNs).ifPresent(this::conclude);
      SearchFact.Assigned now = assigned(assigner.duty());
      if (!now.equals(duty.get())) {
        duty.set(now);
        tellSoon();
      }
    }
  }

  private void tell(long forMs) {
    Report report = report();
    known.hear(report);
    broadcast.BCast(report, forMs);
    tellAtNs = gvh.plat.clock.nowNs() + PERIOD_NS;
    showSwept();
  }

  private Report report() {
    reports++;
    Optional<Point> at = gvh.gps.hasFix() ? Optional.of(gvh.gps.pose().at()) : Optional.empty();
    return new Report(
        me,
        reports,
        at,
        room,
        room == Report.NO_ROOM ? List.of() : RunLengths.of(known.seen(room), house.room(room)),
        known.swept(),
        List.of(tries),
        Optional.ofNullable(assigner).map(Assigner::duty),
        known.answer());
  }

  private void heard(RobotId from, Report report) {
    if (!report.from().robot().equals(from)) {
      return; // a report in another robot's name
    }
    known.hear(report);
    showSwept();
    if (assigner != null) {
      assigner.heard(from, gvh.plat.clock.nowNs());
    }
    if (report.answer().isEmpty() && isDecided()) {
      // It has missed the decision, or has restarted since.
      known.conclude(decision());
      tell(TELL_MS);
    }
  }

  private void showSwept() {
    swept.set(
        new SearchFact.Rooms(known.swept().stream().map(this::name).collect(Collectors.toList())));
  }

  private SearchFact.Assigned assigned(Report.Duty latest) {
    SortedMap<RobotId, String> rooms = new TreeMap<>();
    latest.tasks().forEach((robot, task) -> rooms.put(robot, name(task.room())));
    return new SearchFact.Assigned(latest.term(), rooms);
  }

  private String name(int index) {
    return house.room(index).name();
  }
}
