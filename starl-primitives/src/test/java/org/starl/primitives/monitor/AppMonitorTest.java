package org.starl.primitives.monitor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Codec;
import org.starl.geometry.ItemPosition;
import org.starl.gvh.GvhCell;
import org.starl.id.RobotId;
import org.starl.motion.MotionFlag;
import org.starl.primitives.agreement.SetAgreement;
import org.starl.primitives.barrier.Barrier;
import org.starl.primitives.barrier.BarrierOutcome;
import org.starl.primitives.election.Election;
import org.starl.primitives.election.Leader;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.registration.Registration;
import org.starl.shape.Shapes;
import org.starl.sim.SimResult;
import org.starl.sim.Simulation;
import org.starl.trace.Var;

/** What a monitor of an app's own is passed, against what the robots themselves saw. */
class AppMonitorTest {

  private static final int ROBOTS = 3;

  /** Uses each primitive once, and notes what it saw. */
  private static final class Busy extends LogicThread {
    private static final Var<String> PHASE = Var.of("phase", Shapes.TEXT);
    private final GvhCell<String> phase;
    private final List<String> seen;

    Busy(GlobalVarHolder gvh, List<String> seen) {
      super(gvh);
      this.seen = seen;
      phase = gvh.variable(PHASE, "START");
    }

    private void note(String what) {
      seen.add(gvh.id.name() + " " + what);
    }

    @Override
    public List<Object> callStarL() {
      Registration registration = new Registration(gvh, "town");
      registration.do_register();
      await(registration::mayRequest);
      note("view town " + registration.view());
      Election election = new Election(gvh, "convoy");
      election.do_election();
      await(() -> election.Leader().get().isElected());
      note("leader convoy " + election.Leader().get());
      SetAgreement<String> agreement = new SetAgreement<>(gvh, "colour", Codec.text());
      agreement.propose("red");
      await(() -> agreement.decided().get().isDecided());
      note("decided colour " + agreement.decided().get());
      M_Mutex mutex = new M_Mutex(gvh, "dock", gvh.id.participants());
      mutex.do_mutex(List.of("S"));
      note("requested dock [S]");
      await(() -> mutex.crit().get());
      note("granted dock [S]");
      gvh.plat.moat.doMove(
          new ItemPosition("near", 100 + 1000 * (gvh.id.name().name().charAt(3) - '0'), 0));
      await(() -> !gvh.plat.moat.inMotion());
      note("motion " + gvh.plat.moat.motionflag().get());
      mutex.release("S");
      note("released dock []");
      Barrier barrier = new Barrier(gvh, "end");
      barrier.arrive();
      await(() -> barrier.outcome().get().isTold());
      note("outcome end " + barrier.outcome().get());
      phase.set("DONE");
      note("phase DONE");
      return returnResults();
    }
  }

  /** Notes what it is passed, in the robots' words. */
  private static final class Notes extends AppMonitor {
    private final List<String> notes;
    private final SortedSet<RobotId> holders = new TreeSet<>();

    Notes(List<String> notes) {
      this.notes = notes;
      lemma("one", "At most one robot holds the dock.");
      on(Busy.PHASE, (robot, value) -> note(robot, "phase " + value));
    }

    private void note(RobotId robot, String what) {
      notes.add(robot + " " + what);
    }

    @Override
    protected void onRequested(RobotId robot, String mutex, SortedSet<String> sections) {
      note(robot, "requested " + mutex + " " + sections);
    }

    @Override
    protected void onGranted(RobotId robot, String mutex, SortedSet<String> sections) {
      note(robot, "granted " + mutex + " " + sections);
      holders.add(robot);
      check("one", holders.size() == 1, holders, "hold the dock");
    }

    @Override
    protected void onReleased(RobotId robot, String mutex, SortedSet<String> left) {
      note(robot, "released " + mutex + " " + left);
      holders.remove(robot);
    }

    @Override
    protected void onLeader(RobotId robot, String election, Leader leader) {
      note(robot, "leader " + election + " " + leader);
    }

    @Override
    protected void onOutcome(RobotId robot, String barrier, BarrierOutcome outcome) {
      note(robot, "outcome " + barrier + " " + outcome);
    }

    @Override
    protected void onView(RobotId robot, String registration, View view) {
      note(robot, "view " + registration + " " + view);
    }

    @Override
    protected void onDecided(RobotId robot, String agreement, String decision) {
      note(robot, "decided " + agreement + " " + decision);
    }

    @Override
    protected void onMotion(RobotId robot, MotionFlag flag) {
      note(robot, "motion " + flag);
    }

    @Override
    protected void onEnd() {
      notes.add("end");
    }
  }

  private static SimResult run(List<String> seen, List<String> notes) {
    return Simulation.builder()
        .seed(3)
        .robots(ROBOTS, gvh -> new Busy(gvh, seen))
        .monitor(() -> new Notes(notes))
        .build()
        .run();
  }

  @Test
  void everyPrimitiveIsPassedToTheMonitorAsItsRobotSawIt() {
    List<String> seen = Collections.synchronizedList(new ArrayList<>());
    List<String> notes = new ArrayList<>();
    SimResult result = run(seen, notes);
    assertThat(result.isFinished()).isTrue();
    assertThat(seen).hasSize(9 * ROBOTS).isSubsetOf(notes);
    assertThat(notes).last().isEqualTo("end");
    assertThat(result.spec().checks("one")).isEqualTo(ROBOTS);
    assertThat(result.spec().holds()).isTrue();
  }

  @Test
  void aFailedCheckIsAViolationOfItsLemma() {
    SimResult result =
        Simulation.builder()
            .seed(3)
            .robots(ROBOTS, gvh -> new Busy(gvh, new ArrayList<>()))
            .monitor(NeverGranted::new)
            .build()
            .run();
    assertThat(result.spec().violations("never")).isEqualTo(ROBOTS);
    assertThat(result.spec().violations().get(0).detail()).isEqualTo("granted [S]");
  }

  @Test
  void aCheckOfAnUnknownLemmaFailsTheRun() {
    assertThatThrownBy(() ->
            Simulation.builder()
                .robots(1, gvh -> new Busy(gvh, new ArrayList<>()))
                .monitor(Unnamed::new)
                .build()
                .run())
        .hasStackTraceContaining("check(other): expected one of [never]");
  }

  private static class NeverGranted extends AppMonitor {
    NeverGranted() {
      lemma("never", "No robot is granted anything.");
    }

    @Override
    protected void onGranted(RobotId robot, String mutex, SortedSet<String> sections) {
      check("never", false, List.of(robot), "granted " + sections);
    }
  }

  private static final class Unnamed extends NeverGranted {
    @Override
    protected void onGranted(RobotId robot, String mutex, SortedSet<String> sections) {
      check("other", true, List.of(robot), "");
    }
  }
}
