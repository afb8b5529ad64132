package org.starl.apps.search.logic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Point;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;

/** The leader assigns rooms, takes them back, and concludes the search. */
class AssignerTest {

  private static final long SECOND_NS = 1_000_000_000;
  private static final RobotId ME = new RobotId("bot0");
  private static final RobotId OTHER = new RobotId("bot1");
  private static final RobotId THIRD = new RobotId("bot2");
  private static final Participants ALL = Participants.of(ME, OTHER, THIRD);
  private static final House HOUSE = TwoRooms.HOUSE;

  private final Knowledge known = new Knowledge(HOUSE);
  private final Assigner leader = new Assigner(HOUSE, ME, ALL, 1, 0);
  private long reports;

  private void hear(RobotId robot, double xMm, int room, List<Integer> swept, int... tries) {
    List<Integer> all = tries.length == 0 ? List.of(0, 0) : List.of(tries[0], tries[1]);
    reports++;
    known.hear(
        new Report(
            ProcessId.first(robot, 1),
            reports,
            Optional.of(new Point(xMm, 1_500)),
            room,
            List.of(),
            new TreeSet<>(swept),
            all,
            Optional.empty(),
            Optional.empty()));
  }

  private void isUp(RobotId robot, double xMm, int room, long atS, int... tries) {
    hear(robot, xMm, room, List.of(), tries);
    leader.heard(robot, atS * SECOND_NS);
  }

  private int roomOf(RobotId robot) {
    return roomIn(leader, robot);
  }

  private static int roomIn(Assigner assigner, RobotId robot) {
    Report.Task task = assigner.duty().tasks().get(robot);
    return task == null ? Report.NO_ROOM : task.room();
  }

  @Test
  void itAssignsNothingBeforeItHasHeardAllRobotsThatAreNotSilent() {
    hear(ME, 4_000, Report.NO_ROOM, List.of());
    isUp(OTHER, 5_000, Report.NO_ROOM, 1);
    assertThat(leader.work(known, SECOND_NS)).isEmpty();
    assertThat(leader.duty().tasks()).isEmpty();
    // The third one has been silent for long enough.
    assertThat(leader.work(known, 6 * SECOND_NS)).isEmpty();
    assertThat(leader.duty().tasks()).hasSize(2);
  }

  @Test
  void aRoomThatItsRobotGivesUpIsAssignedAgainAtOnce() {
    hear(ME, 4_000, Report.NO_ROOM, List.of());
    isUp(OTHER, 5_500, Report.NO_ROOM, 1);
    isUp(THIRD, 2_500, Report.NO_ROOM, 1);
    assertThat(leader.work(known, SECOND_NS)).isEmpty();
    isUp(OTHER, 5_500, 1, 2);
    assertThat(leader.work(known, 2 * SECOND_NS)).isEmpty();
    isUp(OTHER, 5_500, Report.NO_ROOM, 3, 0, 1);
    assertThat(leader.work(known, 3 * SECOND_NS)).isEmpty();
    assertThat(roomOf(ME)).isEqualTo(1);
  }

  @Test
  void theNearestRobotGetsARoom() {
    hear(ME, 4_000, Report.NO_ROOM, List.of());
    isUp(OTHER, 5_500, Report.NO_ROOM, 1);
    isUp(THIRD, 2_500, Report.NO_ROOM, 1);
    assertThat(leader.work(known, SECOND_NS)).isEmpty();
    assertThat(roomOf(OTHER)).isEqualTo(1);
    assertThat(roomOf(THIRD)).isZero();
    assertThat(roomOf(ME)).isEqualTo(Report.NO_ROOM);
  }

  @Test
  void aRoomThatARobotSearchesIsNotAssigned() {
    hear(ME, 4_000, Report.NO_ROOM, List.of());
    isUp(OTHER, 5_500, 0, 1);
    isUp(THIRD, 2_500, Report.NO_ROOM, 1);
    assertThat(leader.work(known, SECOND_NS)).isEmpty();
    assertThat(leader.duty().tasks().values()).extracting(Report.Task::room).containsExactly(1);
  }

  @Test
  void theRoomOfARobotThatFallsSilentIsAssignedAgain() {
    theNearestRobotGetsARoom();
    isUp(OTHER, 5_500, 1, 5);
    isUp(THIRD, 2_500, 0, 5);
    leader.work(known, 5 * SECOND_NS);
    isUp(OTHER, 5_500, 1, 12);
    leader.work(known, 12 * SECOND_NS);
    assertThat(roomOf(THIRD)).isEqualTo(Report.NO_ROOM);
    assertThat(roomOf(ME)).isZero();
  }

  @Test
  void aRoomThatItsRobotDoesNotTakeIsAssignedAnew() {
    theNearestRobotGetsARoom();
    int first = leader.duty().tasks().get(THIRD).number();
    for (int atS : new int[] {6, 11}) {
      isUp(OTHER, 5_500, 1, atS);
      isUp(THIRD, 2_500, Report.NO_ROOM, atS);
      leader.work(known, atS * SECOND_NS);
      assertThat(leader.duty().tasks().get(THIRD).number()).isEqualTo(first);
    }
    leader.work(known, 12 * SECOND_NS);
    assertThat(leader.duty().tasks().get(THIRD).number()).isGreaterThan(first);
  }

  @Test
  void whenAllRoomsAreSearchedTheAnswerIsNothingThere() {
    theNearestRobotGetsARoom();
    hear(OTHER, 5_500, Report.NO_ROOM, List.of(0, 1));
    hear(THIRD, 5_500, Report.NO_ROOM, List.of(0, 1));
    assertThat(leader.work(known, 2 * SECOND_NS)).contains(Answer.NOTHING);
  }

  @Test
  void aRoomIsGivenUpWhenAllHaveTriedItAndARobotIsDead() {
    hear(ME, 4_000, Report.NO_ROOM, List.of(0), 0, 2);
    isUp(OTHER, 5_500, Report.NO_ROOM, 1, 0, 2);
    isUp(THIRD, 2_500, Report.NO_ROOM, 1, 0, 2);
    assertThat(leader.work(known, 2 * SECOND_NS)).as("all are up").isEmpty();
    Assigner later = new Assigner(HOUSE, ME, ALL, 2, 0);
    later.heard(OTHER, 9 * SECOND_NS);
    assertThat(later.work(known, 9 * SECOND_NS)).as("silent, maybe not dead").isEmpty();
    assertThat(roomIn(later, OTHER)).isEqualTo(1);
    later.heard(OTHER, 61 * SECOND_NS);
    hear(OTHER, 5_500, 1, List.of(0), 0, 2);
    assertThat(later.work(known, 61 * SECOND_NS)).as("it tries").isEmpty();
    hear(OTHER, 5_500, Report.NO_ROOM, List.of(0), 0, 3);
    assertThat(later.work(known, 61 * SECOND_NS)).contains(new Answer.GaveUp(List.of("B")));
  }
}
