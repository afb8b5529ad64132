package org.starl.apps.recipes;

import java.util.List;
import java.util.Set;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Codec;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Rectangle;
import org.starl.gvh.GvhCell;
import org.starl.primitives.agreement.Decision;
import org.starl.primitives.agreement.SetAgreement;
import org.starl.primitives.barrier.Barrier;
import org.starl.primitives.barrier.BarrierOutcome;
import org.starl.primitives.geocast.Broadcast;
import org.starl.primitives.geocast.GeocastReceipt;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.OptimalPlanner;
import org.starl.primitives.paths.TubeFailure;
import org.starl.shape.Shapes;
import org.starl.trace.Var;

/**
 * One robot of a formation. The robots agree on a leader and its formation; the leader announces the
 * formation, all meet at a barrier, and each drives to its place along reach tubes.
 */
final class FormationApp extends LogicThread {

  static final Rectangle FLOOR = new Rectangle(0, 0, 5000, 3000);

  static final Var<String> FORMATION = Var.of("formation", Shapes.TEXT);
  static final Var<Boolean> DRIVING = Var.of("driving", Shapes.BOOL);

  private static final String NONE = "";
  private static final long ANNOUNCED_MS = 2_000;

  private final SetAgreement<String> choice;
  private final Broadcast<String> news;
  private final Barrier barrier;
  private final DistributedPathPlanning paths;
  private final GvhCell<String> formation;
  private final GvhCell<Boolean> driving;
  private final int number;

  FormationApp(GlobalVarHolder gvh, int number) {
    super(gvh);
    this.number = number;
    choice = new SetAgreement<>(gvh, "leader", Codec.text());
    barrier = new Barrier(gvh, "ready");
    paths = new DistributedPathPlanning(gvh, "floor", new OptimalPlanner(), FLOOR);
    formation = gvh.variable(FORMATION, NONE);
    driving = gvh.variable(DRIVING, false);
    news = new Broadcast<>(gvh, "news", Codec.text(), (from, text) -> formation.set(text));
  }

  @Override
  public List<Object> callStarL() {
    await(gvh.gps::hasFix);
    if (agreedLeader().equals(gvh.id.name().toString())) {
      formation.set(number % 2 == 0 ? "line" : "arrow");
      announce(formation.get());
    }
    await("the formation is known", () -> !formation.get().equals(NONE));
    meet();
    driving.set(true);
    driveTo(place(formation.get(), number));
    return List.of(formation.get());
  }

  /** Each robot proposes itself. */
  private String agreedLeader() {
    do {
      choice.propose(gvh.id.name().toString());
      await("a leader", () -> choice.decided().get().isDecided() || choice.failed().get());
    } while (!choice.decided().get().isDecided());
    return choice.decided().get() instanceof Decision.Decided<String> decided
        ? decided.value()
        : NONE;
  }

  /** Announces the formation until all others have it. */
  private void announce(String text) {
    int others = gvh.id.participants().asList().size() - 1;
    Set<?> told;
    do {
      GeocastReceipt sent = news.BCast(text, ANNOUNCED_MS);
      await("all have heard", sent::isComplete);
      told = Set.copyOf(sent.acknowledgedBy());
    } while (told.size() < others);
  }

  /** Waits for the others. Without a majority in reach there is no outcome: wait again. */
  private void meet() {
    do {
      barrier.arrive();
      await("all are ready", () -> barrier.outcome().get().isTold());
    } while (barrier.outcome().get() instanceof BarrierOutcome.Unknown);
  }

  private void driveTo(ItemPosition place) {
    TubeFailure failure;
    do {
      failure = paths.drive(place, 60_000);
    } while (failure != TubeFailure.NONE);
  }

  /** The place of a robot: 900 mm or more from the other places, and far from all starts. */
  static ItemPosition place(String formation, int robot) {
    double forward = formation.equals("line") ? 0 : 500 * Math.abs(robot - 1.5);
    return new ItemPosition("place", 1150 + 900 * robot, 2500 - forward);
  }
}
