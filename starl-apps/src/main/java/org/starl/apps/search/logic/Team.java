package org.starl.apps.search.logic;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
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

/**
 * One robot's part in the team: tells everybody by Broadcast what it does and knows, once a second;
 * leads while Election says so; and brings about one answer by SetAgreement. Strand only.
 */
final class Team {

  private static final long NS_PER_MS = 1_000_000;
  private static final long PERIOD_NS = 1_000 * NS_PER_MS;
  private static final long TELL_MS = 950;
  private static final long LAST_WORD_MS = 30_000;
  private static final long LOOK_NS = 500 * NS_PER_MS;

  private final GlobalVarHolder gvh;
  private final House house;
  private final Board board;
  private final Election election;
  private final SetAgreement end;
  private final Broadcast<Report> broadcast;
  private final ProcessId me;
  private final int[] tries;
  private final GvhCell<String> duty;
  private final GvhCell<String> swept;
  private @Nullable Assigner assigner;
  private int room = Report.NO_ROOM;
  private long reports;
  private long tellAtNs;
  private long lookAtNs;
  private long takenTerm;
  private int takenNumber;
  private boolean isProposing;

  Team(GlobalVarHolder gvh, String xid, House house) {
    this.gvh = gvh;
    this.house = house;
    board = new Board(house);
    me = gvh.id.freshProcess();
    tries = new int[house.rooms().size()];
    duty = gvh.variable(SearchTrace.SOURCE, SearchTrace.DUTY, "");
    swept = gvh.variable(SearchTrace.SOURCE, SearchTrace.SWEPT, "");
    election = new Election(gvh, xid);
    end = new SetAgreement(gvh, xid);
    broadcast =
        new Broadcast<>(
            gvh, xid, new ReportCodec(house.rooms().size()), (from, report) -> heard(from, report));
  }

  void begin() {
    election.do_election();
    end.refresh();
  }

  /** The robot's periodic share: stands for election, leads, tells, agrees. */
  void work() {
    if (election.failed().get()) {
      election.do_election();
    }
    lead();
    long nowNs = gvh.plat.clock.nowNs();
    if (nowNs >= tellAtNs) {
      tell(TELL_MS);
    }
    if (board.answer().isPresent() && !isDecided() && (!isProposing || end.failed().get())) {
      isProposing = true;
      end.propose(Answer.toBytes(board.answer().get()));
    }
  }

  boolean hasLeader() {
    return election.Leader().get().isElected();
  }

  /** Whether all have one answer, as far as this robot knows. */
  boolean isDecided() {
    return end.decided().get().isDecided();
  }

  /** What all have agreed on; it must be decided. */
  Answer decision() {
    if (end.decided().get() instanceof Decision.Decided decided) {
      return Answer.of(decided.value().bytes());
    }
    throw new IllegalStateException("nothing is decided yet");
  }

  /** The end as far as this robot knows, agreed on or not. */
  Optional<Answer> answer() {
    return board.answer();
  }

  void conclude(Answer answer) {
    board.conclude(answer);
    tellSoon();
  }

  /** The room of a task that this robot has not taken before; it has now. */
  Optional<Room> takeTask() {
    Report.Duty latest = board.duty().orElse(null);
    Report.Task task = latest == null ? null : latest.tasks().get(gvh.id.name());
    if (latest == null
        || task == null
        || board.isSwept(task.room())
        || latest.term() < takenTerm
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
    return board.isSwept(which.index());
  }

  /** What somebody has seen of a room, as far as is known here. */
  BitSet seenOf(Room which) {
    return board.seen(which.index());
  }

  /** This robot has seen so much of its room. */
  void saw(BitSet cells) {
    board.saw(room, cells);
  }

  /** This robot has searched its room in full. */
  void sweptRoom() {
    board.swept(room);
    gvh.trace.action(SearchTrace.SOURCE, SearchTrace.SWEPT, house.room(room).name());
    leaveRoom();
  }

  /** This robot has not come into its room, or not everywhere in it. */
  void failedRoom() {
    tries[room] = Math.min(Report.MAX_TRIES, tries[room] + 1);
    leaveRoom();
  }

  /** This robot has no room any more. */
  void leaveRoom() {
    room = Report.NO_ROOM;
    tellSoon();
  }

  /** Its last word, for a while: whoever has missed the end hears of it. */
  void tellTheEnd() {
    board.conclude(decision());
    tell(LAST_WORD_MS);
  }

  private void tellSoon() {
    tellAtNs = gvh.plat.clock.nowNs();
  }

  private void lead() {
    boolean leads = election.isLeader() && election.Leader().get() instanceof Leader.Name;
    if (!leads || !(election.Leader().get() instanceof Leader.Name name)) {
      assigner = null;
      duty.set("");
      return;
    }
    long nowNs = gvh.plat.clock.nowNs();
    Assigner mine = assigner;
    if (mine == null || mine.term() != name.term()) {
      mine = new Assigner(house, gvh.id.name(), gvh.id.participants(), name.term(), nowNs);
      assigner = mine;
    }
    if (nowNs >= lookAtNs && board.answer().isEmpty()) {
      lookAtNs = nowNs + LOOK_NS;
      board.hear(report(Optional.of(mine.duty())));
      mine.work(board, nowNs).ifPresent(this::conclude);
      String text = text(mine.duty());
      if (!text.equals(duty.get())) {
        duty.set(text);
        tellSoon();
      }
    }
  }

  private void tell(long forMs) {
    Report report = report(Optional.ofNullable(assigner).map(Assigner::duty));
    board.hear(report);
    broadcast.BCast(report, forMs);
    tellAtNs = gvh.plat.clock.nowNs() + PERIOD_NS;
    showSwept();
  }

  private Report report(Optional<Report.Duty> myDuty) {
    reports++;
    List<Integer> triedRooms = new ArrayList<>();
    for (int count : tries) {
      triedRooms.add(count);
    }
    Optional<Point> at = gvh.gps.hasFix() ? Optional.of(gvh.gps.pose().at()) : Optional.empty();
    List<Integer> seen =
        room == Report.NO_ROOM ? List.of() : Runs.of(board.seen(room), house.room(room));
    return new Report(
        me,
        reports,
        at,
        room,
        seen,
        new TreeSet<>(board.swept()),
        triedRooms,
        myDuty,
        board.answer());
  }

  private void heard(RobotId from, Report report) {
    if (!report.from().robot().equals(from)) {
      return; // nobody speaks for another robot
    }
    board.hear(report);
    showSwept();
    if (assigner != null) {
      assigner.heard(from, gvh.plat.clock.nowNs());
    }
    if (report.answer().isEmpty() && isDecided()) {
      // It has missed the end, or is back from the dead.
      board.conclude(decision());
      tell(TELL_MS);
    }
  }

  private void showSwept() {
    List<String> names = new ArrayList<>();
    board.swept().forEach(index -> names.add(house.room(index).name()));
    swept.set(String.join(" ", names));
  }

  /** {@code 3 bot1=A bot2=C}. */
  private String text(Report.Duty latest) {
    StringBuilder text = new StringBuilder().append(latest.term());
    latest
        .tasks()
        .forEach((robot, task) -> {
          text.append(' ').append(robot).append('=').append(house.room(task.room()).name());
        });
    return text.toString();
  }
}
