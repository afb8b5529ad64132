package org.starl.apps.maze.logic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.starl.body.Bumps;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Segment;
import org.starl.motion.Contact;
import org.starl.motion.Location;
import org.starl.primitives.paths.Capsule;

/** A robot's goals, and which answer it gives when. */
class AgendaTest {

  private static final Rectangle FLOOR = new Rectangle(0, 0, 6_000, 6_000);
  private static final Point START = new Point(500, 500);
  private static final Goal FIRST = new Goal("first", new Point(2_000, 500), 50);
  private static final Goal SECOND = new Goal("second", new Point(4_000, 500), 60);

  private static MazeTask task(List<Capsule> others) {
    Blocks blocks = Blocks.of(FLOOR);
    return new MazeTask(START, List.of(FIRST, SECOND), others, FLOOR, blocks, CollisionMode.STOP);
  }

  private static final Point AT = new Point(3_000, 3_000);

  private final Agenda agenda = new Agenda(task(List.of()));

  @Test
  void aReachedGoalIsTheNextRestingPlace() {
    assertThat(agenda.to()).isEqualTo(FIRST.at());
    assertThat(agenda.toleranceMm()).isEqualTo(50);
    assertThat(agenda.arrived()).isEqualTo(Answer.REACHED);
    assertThat(agenda.answer(Answer.REACHED)).isEqualTo(FIRST);
    agenda.backForGood();
    assertThat(agenda.to()).isEqualTo(FIRST.at());
  }

  @Test
  void noWayIsAnsweredBackAtTheRestingPlace() {
    agenda.backForGood();
    assertThat(agenda.goesBack()).isTrue();
    assertThat(agenda.to()).isEqualTo(START);
    assertThat(agenda.arrived()).isEqualTo(Answer.NO_WAY);
    agenda.answer(Answer.NO_WAY);
    assertThat(agenda.goesBack()).isFalse();
    assertThat(agenda.to()).isEqualTo(SECOND.at());
    assertThat(agenda.answers()).containsExactly("first NO_WAY");
    agenda.backForMore(Set.of(), Set.of());
    assertThat(agenda.arrived()).as("it is not cut off from its second goal").isNull();
  }

  @Test
  void blocksOfEarlierWaysAreNeededForOneGoalOnlyAndNothingIsAnsweredBeforeIt() {
    agenda.backForMore(Set.of("0.0"), Set.of("0.0", "0.1"));
    assertThat(agenda.to()).isEqualTo(START);
    assertThat(agenda.arrived()).isNull();
    assertThat(agenda.to()).isEqualTo(FIRST.at());
    assertThat(agenda.withNeeded(Set.of("1.1"))).containsExactly("0.0", "0.1", "1.1");
    agenda.answer(Answer.REACHED);
    assertThat(agenda.withNeeded(Set.of("1.1"))).containsExactly("1.1");
    agenda.answer(Answer.GAVE_UP);
    assertThat(agenda.isDone()).isTrue();
    assertThat(agenda.answers()).containsExactly("first REACHED", "second GAVE_UP");
  }

  @Test
  void aContactNearAnotherRobotsPlaceMayBeWithThatRobot() {
    Capsule other = new Capsule(new Segment(AT, AT), 165);
    MazeTask task = task(List.of(other));
    assertThat(task.mayBeOther(contact(3_000 - 165 - 165 - 10 - 39, 10), 165)).isTrue();
    assertThat(task.mayBeOther(contact(3_000 - 165 - 165 - 10 - 41, 10), 165)).isFalse();
  }

  private static Contact contact(double xMm, double errorMm) {
    Pose at = new Pose(xMm, 3_000, 0);
    return new Contact(new Location.Known(at, errorMm, 0, 0, 0), Bumps.BOTH);
  }
}
