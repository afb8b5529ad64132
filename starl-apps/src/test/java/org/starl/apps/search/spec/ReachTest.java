package org.starl.apps.search.spec;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.apps.search.logic.House;
import org.starl.apps.search.logic.Room;
import org.starl.apps.search.logic.TwoRooms;
import org.starl.id.RobotId;
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

  private void holds(String tube) {
    reach.observe(new Variable(SECOND_NS, DEAD, "tubes/house", "held", tube));
  }

  private void crashes() {
    reach.observe(new Fault(2 * SECOND_NS, DEAD, Fault.CRASH, ""));
  }

  private boolean isInReach(Room room, long atS) {
    return reach.isInReach(room, List.of(TwoRooms.HALL), atS * SECOND_NS);
  }

  @Test
  void aRobotThatIsUpBarsNothing() {
    holds("244@2000,1500");
    assertThat(isInReach(A, 3)).isTrue();
  }

  @Test
  void aTubeInTheDoorBarsTheRoomBehindIt() {
    holds("244@2000,1500");
    crashes();
    assertThat(isInReach(A, 3)).isFalse();
    assertThat(isInReach(B, 3)).isTrue();
  }

  @Test
  void aTubeInTheHallBarsNothingIfAWayLeadsPastIt() {
    holds("244@4000,300");
    crashes();
    assertThat(isInReach(A, 3)).isTrue();
    assertThat(isInReach(B, 3)).isTrue();
  }

  @Test
  void aTubeInACornerBarsTheCellsThatCanOnlyBeSeenFromThere() {
    holds("244@300,300");
    crashes();
    assertThat(isInReach(A, 3)).isFalse();
  }

  @Test
  void aRobotThatIsBackBarsNothingAfterAWhile() {
    holds("244@2000,1500");
    crashes();
    reach.observe(new Fault(10 * SECOND_NS, DEAD, Fault.RESTART, ""));
    assertThat(isInReach(A, 11)).as("others do not know yet").isFalse();
    assertThat(isInReach(A, 60)).isTrue();
  }
}
