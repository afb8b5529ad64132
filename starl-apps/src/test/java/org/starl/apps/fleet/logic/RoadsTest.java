package org.starl.apps.fleet.logic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.apps.fleet.logic.NavGraph.Lane;
import org.starl.apps.fleet.logic.NavGraph.Vertex;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;
import org.starl.random.Rng;

class RoadsTest {

  private static final double BODY_MM = 165;

  private static Vertex place(String name, double x, double y, boolean isStation, boolean isPark) {
    return new Vertex(name, new Point(x, y), false, isStation, isPark);
  }

  private static NavGraph random(Rng rng) {
    List<Vertex> vertices = new ArrayList<>();
    for (int i = 0; i < 12; i++) {
      double x = 4_000 * rng.nextDouble();
      double y = 4_000 * rng.nextDouble();
      vertices.add(place("v" + i, x, y, false, rng.nextDouble() < 0.3));
    }
    List<Lane> lanes = new ArrayList<>();
    for (int i = 0; i < 14; i++) {
      int from = (int) (12 * rng.nextDouble());
      int to = (from + 1 + (int) (11 * rng.nextDouble())) % 12;
      lanes.add(new Lane(from, to, ""));
      lanes.add(new Lane(to, from, ""));
    }
    return new NavGraph(vertices, lanes);
  }

  /** Vertices may be near, lanes may cross. */
  @Property(tries = 200)
  void robotsThatCouldTouchOnTwoLanesNeedOneSection(@ForAll long seed) {
    NavGraph graph = random(new Rng(seed));
    Roads roads = new Roads(graph, BODY_MM, 0);
    for (Lane one : graph.lanes()) {
      for (Lane other : graph.lanes()) {
        double mm = segment(graph, one).distanceMm(segment(graph, other));
        if (mm < 2 * BODY_MM) {
          assertThat(Collections.disjoint(needs(roads, one), needs(roads, other)))
              .as("%s and %s, %s mm", one, other, mm)
              .isFalse();
        }
      }
    }
  }

  private static List<String> needs(Roads roads, Lane lane) {
    return roads.needs(roads.at(lane.from()), lane);
  }

  private static Segment segment(NavGraph graph, Lane lane) {
    return new Segment(
        graph.vertices().get(lane.from()).at(), graph.vertices().get(lane.to()).at());
  }

  /** Two homes at the ends of a corridor; a station at a vertex between them, or beside it. */
  private static NavGraph corridor(boolean isBeside) {
    List<Vertex> vertices =
        List.of(
            place("west", 0, 0, false, true),
            place("a", 1_300, 0, false, false),
            place("b", 2_600, 0, !isBeside, false),
            place("east", 3_900, 0, false, true),
            place("s", 1_300, 1_300, true, false));
    List<Lane> lanes = new ArrayList<>();
    for (int[] pair : new int[][] {{0, 1}, {1, 2}, {2, 3}, {1, 4}}) {
      lanes.add(new Lane(pair[0], pair[1], ""));
      lanes.add(new Lane(pair[1], pair[0], ""));
    }
    return new NavGraph(vertices, lanes);
  }

  @Test
  void noWayLeadsThroughAHomeOrAStationBesideTheWay() {
    Roads roads = new Roads(corridor(true), BODY_MM, 2);
    assertThat(roads.home(0)).isZero();
    assertThat(roads.home(1)).isEqualTo(3);
    assertThat(roads.isPrivate(4)).isTrue();
    assertThat(roads.way(0, List.of(4, 3))).containsExactly(0, 1, 4, 1, 2, 3);
    assertThat(roads.leg(0, List.of(4, 2), 0)).containsExactly(4);
  }

  @Test
  void aStationOnTheOnlyWayIsShared() {
    Roads roads = new Roads(corridor(false), BODY_MM, 2);
    assertThat(roads.isPrivate(2)).isFalse();
    assertThat(roads.leg(0, List.of(2), 0)).containsExactly(2, 0);
  }

  /** The corridor; the station and the lane from "a" to "b" are one group. */
  private static Roads grouped() {
    NavGraph graph = corridor(true);
    List<Vertex> vertices = new ArrayList<>(graph.vertices());
    Vertex s = vertices.get(4);
    vertices.set(4, new Vertex(s.name(), s.at(), false, true, false, "gate"));
    List<Lane> lanes = new ArrayList<>(graph.lanes());
    lanes.replaceAll(lane -> lane.equals(new Lane(1, 2, "")) ? new Lane(1, 2, "gate") : lane);
    return new Roads(new NavGraph(vertices, lanes), BODY_MM, 2);
  }

  @Test
  void aRobotAtAStationKeepsTheGroupThatTheStationHasInCommonWithOtherLanes() {
    assertThat(grouped().isPrivate(4)).isFalse();
    assertThat(grouped().leg(0, List.of(4), 0)).containsExactly(4, 0);
  }

  @Test
  void aRestartedRobotHasTheGroupInWhoseLaneItStandsAndNoneThatItMayWaitFor() {
    Roads roads = grouped();
    assertThat(roads.groups(new Point(1_950, 0), new Lane(1, 2, "gate"))).containsExactly("g0");
    assertThat(roads.groups(new Point(1_340, 0), new Lane(1, 2, "gate"))).isEmpty();
    assertThat(roads.groups(new Point(1_300, 1_270), new Lane(1, 4, ""))).containsExactly("g0");
    assertThat(roads.groups(new Point(600, 0), new Lane(0, 1, ""))).isEmpty();
  }

  @Test
  void aRobotBesideALaneIsNotOnIt() {
    Roads roads = new Roads(corridor(true), BODY_MM, 2);
    assertThat(roads.laneAt(new Point(1_310, 10), 3)).isEqualTo(new Lane(1, 2, ""));
    assertThat(roads.laneAt(new Point(1_300, 45), 3)).isEqualTo(new Lane(4, 1, ""));
  }

  @Test
  void aRestartedRobotLeavesTheLanesAtTheNearestPrivateVertex() {
    Roads roads = new Roads(corridor(true), BODY_MM, 2);
    assertThat(roads.refuges(new Point(1_500, 0), 3)).containsExactly(4, 3);
    assertThat(roads.refuges(new Point(2_400, 0), 3)).containsExactly(3);
    assertThat(roads.refuges(new Point(1_300, 600), 0)).containsExactly(4, 0);
    assertThat(roads.refuges(new Point(200, 0), 0)).containsExactly(0);
  }

  @Test
  void aRestartedRobotOnItsWayToAVertexThatIsTakenMayTurnBack() {
    NavGraph both = corridor(true);
    List<Lane> lanes = new ArrayList<>(both.lanes());
    lanes.remove(new Lane(4, 1, "")); // one way, from "a" over "s" to "b"
    lanes.add(new Lane(4, 2, ""));
    Roads roads = new Roads(new NavGraph(both.vertices(), lanes), BODY_MM, 2);
    Point towardsS = new Point(1_300, 600);
    assertThat(roads.refuges(towardsS, 0)).containsExactly(4, 0);
    assertThat(roads.laneAt(towardsS, 4)).isEqualTo(new Lane(1, 4, ""));
    assertThat(roads.laneAt(towardsS, 0)).isEqualTo(new Lane(4, 1, ""));
    assertThat(roads.needs(List.of(4, 1, 0))).hasSize(2);
  }

  @Test
  void aMapWithoutRoomForAllRobotsIsRefused() {
    assertThatThrownBy(() -> new Roads(corridor(true), BODY_MM, 3))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("2 parking places")
        .hasMessageContaining("3 robots");
  }

  @Test
  void aStationThatCannotBeReachedIsRefused() {
    NavGraph graph = corridor(true);
    List<Lane> lanes = new ArrayList<>(graph.lanes());
    lanes.removeIf(lane -> lane.to() == 4);
    assertThatThrownBy(() -> new Roads(new NavGraph(graph.vertices(), lanes), BODY_MM, 2))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("no way from west to s");
  }
}
