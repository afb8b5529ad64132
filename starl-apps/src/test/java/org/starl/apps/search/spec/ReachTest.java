package org.starl.apps.search.spec;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.apps.search.logic.House;
import org.starl.apps.search.logic.Room;
import org.starl.apps.search.logic.TwoRooms;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.primitives.paths.Tube;
import org.starl.primitives.paths.TubeFact;
import org.starl.primitives.paths.TubeList;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Variable;

/** The tubes of a robot that is down bar the way; nothing else does. */
class ReachTest {

  private static final long SECOND_NS = 1_000_000_000;
  private static final RobotId DEAD = new RobotId("bot1");
  private static final House HOUSE = TwoRooms.HOUSE;
  private static final Room A = HOUSE.room(0);
  private static final Room B = HOUSE.room(1);

  private final Reach reach = new Reach(HOUSE);

  private void holds(double xMm, double yMm) {
    TubeList held = new TubeList(List.of(new Tube(List.of(new Point(xMm, yMm)), 244)));
    Instance tubes = Instance.of(TubeFact.PRIMITIVE, "house");
    reach.observe(new Variable(SECOND_NS, DEAD, tubes, TubeFact.HELD, held));
  }

  private void crashes() {
    reach.observe(new Fault(2 * SECOND_NS, DEAD, Fault.CRASH, ""));
  }

  private boolean isInReach(Room room, long atS) {
    return reach.isInReach(room, List.of(TwoRooms.HALL), atS * SECOND_NS);
  }

  @Test
  void aRobotThatIsUpBarsNothing() {
    holds(2_000, 1_500);
    assertThat(isInReach(A, 3)).isTrue();
  }

  @Test
  void aTubeInTheDoorBarsTheRoomBehindIt() {
    holds(2_000, 1_500);
    crashes();
    assertThat(isInReach(A, 3)).isFalse();
    assertThat(isInReach(B, 3)).isTrue();
  }

  @Test
  void aTubeInTheHallBarsNothingIfAWayLeadsPastIt() {
    holds(4_000, 300);
    crashes();
    assertThat(isInReach(A, 3)).isTrue();
    assertThat(isInReach(B, 3)).isTrue();
  }

  @Test
  void aTubeInACornerBarsTheCellsThatCanOnlyBeSeenFromThere() {
    holds(300, 300);
    crashes();
    assertThat(isInReach(A, 3)).isFalse();
  }

  @Test
  void aRobotThatIsBackBarsNothingAfterAWhile() {
    holds(2_000, 1_500);
    crashes();
    reach.observe(new Fault(10 * SECOND_NS, DEAD, Fault.RESTART, ""));
    assertThat(isInReach(A, 11)).as("others do not know yet").isFalse();
    assertThat(isInReach(A, 60)).isTrue();
  }
}
