package org.starl.apps.intersection.logic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Region;

/** Figure 2: where the zones lie, and which of them each of the twelve routes needs. */
class CrossingTest {

  private static final double RADIUS_MM = 165;

  static Stream<Route> routes() {
    return Route.all().stream();
  }

  @Test
  void thePapersRoutesAreAmongTheTwelve() {
    assertThat(Route.all()).hasSize(12).doesNotHaveDuplicates();
    assertThat(Route.all().stream().map(Route::toString))
        .containsExactlyInAnyOrder(
            "A0 A A1",
            "A0 A C C1",
            "A0 A C D D1",
            "C0 C C1",
            "C0 C D D1",
            "C0 C D B B1",
            "D0 D D1",
            "D0 D B B1",
            "D0 D B A A1",
            "B0 B B1",
            "B0 B A A1",
            "B0 B A C C1");
  }

  @ParameterizedTest
  @MethodSource("routes")
  void aRouteIsParsedFromItsText(Route route) {
    assertThat(Route.parse(route.toString())).contains(route);
    assertThat(Route.parse(route + " X")).isEmpty();
  }

  @Test
  void criticalZonesAreTheSquaresAroundTheMiddle() {
    assertThat(Crossing.region("A")).isEqualTo(new Rectangle(2000, 2500, 2500, 3000));
    assertThat(Crossing.region("B")).isEqualTo(new Rectangle(2500, 2500, 3000, 3000));
    assertThat(Crossing.region("C")).isEqualTo(new Rectangle(2000, 2000, 2500, 2500));
    assertThat(Crossing.region("D")).isEqualTo(new Rectangle(2500, 2000, 3000, 2500));
  }

  @Test
  void noTwoZonesOverlap() {
    Map<String, Region> zones = new TreeMap<>(Crossing.regions(Crossing.PLACES));
    for (Zone zone : Zone.values()) {
      zones.put(zone + " exit", Crossing.exitRegion(zone));
    }
    assertThat(zones).hasSize(24);
    List<String> names = new ArrayList<>(zones.keySet());
    for (int i = 0; i < names.size(); i++) {
      for (int j = 0; j < i; j++) {
        Rectangle a = (Rectangle) zones.get(names.get(i));
        Rectangle b = (Rectangle) zones.get(names.get(j));
        boolean apart =
            a.xMaxMm() <= b.xMinMm()
                || b.xMaxMm() <= a.xMinMm()
                || a.yMaxMm() <= b.yMinMm()
                || b.yMaxMm() <= a.yMinMm();
        assertThat(apart).as("%s and %s", names.get(i), names.get(j)).isTrue();
      }
    }
  }

  @ParameterizedTest
  @MethodSource("routes")
  void aTripHasTheZonesOfItsRouteInOrder(Route route) {
    List<String> expected = new ArrayList<>();
    route.zones().forEach(zone -> expected.add(zone.name()));
    expected.add(route.departure());
    Trip trip = Crossing.trip(route, 0);
    assertThat(trip.zones()).isEqualTo(expected);
    assertThat(trip.label()).isEqualTo(route.toString());
    for (ItemPosition station : trip.stations()) {
      assertThat(Crossing.region(station.name()).contains(station.at())).as("%s", station).isTrue();
    }
  }

  @ParameterizedTest
  @MethodSource("routes")
  void aCarFromTheEdgeDrivesPlaceByPlaceToItsArrivalZone(Route route) {
    Trip trip = Crossing.trip(route, Crossing.PLACES - 1);
    String head = route.arrival();
    assertThat(trip.approach()).extracting(ItemPosition::name).containsExactly(head + ".1", head);
    assertThat(trip.stations()).isEqualTo(Crossing.trip(route, 0).stations());
    for (int rank = 0; rank < Crossing.PLACES; rank++) {
      Pose middle = Crossing.placePose(route.from(), rank);
      for (int other = 0; other < Crossing.PLACES; other++) {
        double distanceMm =
            Crossing.region(Crossing.placeName(route.from(), other)).distanceMm(middle.at());
        if (other == rank) {
          assertThat(distanceMm).isZero();
        } else {
          assertThat(distanceMm).isGreaterThan(RADIUS_MM);
        }
      }
    }
  }

  @ParameterizedTest
  @MethodSource("routes")
  void carsAtArrivalPointDeparturePointAndExitAreClearOfTheZonesBefore(Route route) {
    Pose arrival = Crossing.placePose(route.from(), 0);
    assertThat(Crossing.region(route.arrival()).contains(arrival.at())).isTrue();
    Crossing.regions(0)
        .forEach((name, region) ->
            assertThat(region.distanceMm(arrival.at())).as(name).isGreaterThan(RADIUS_MM));
    Trip trip = Crossing.trip(route, 0);
    ItemPosition departure = trip.stations().get(trip.stations().size() - 1);
    for (Zone zone : Zone.values()) {
      assertThat(Crossing.region(zone.name()).distanceMm(departure.at())).isGreaterThan(RADIUS_MM);
    }
    Crossing.regions(0)
        .forEach((name, region) ->
            assertThat(region.distanceMm(trip.exit().at())).as(name).isGreaterThan(RADIUS_MM));
    assertThat(Crossing.exitRegion(route.lastZone()).contains(trip.exit().at())).isTrue();
  }

  @ParameterizedTest
  @MethodSource("routes")
  void aStraightLineFromStationToStationTouchesOnlyTheTripsZones(Route route) {
    Trip trip = Crossing.trip(route, 0);
    Set<String> allowed = new TreeSet<>(trip.zones());
    List<Pose> way = new ArrayList<>();
    way.add(Crossing.placePose(route.from(), 0));
    trip.stations().forEach(station -> way.add(station.pose()));
    way.add(trip.exit().pose());
    for (int leg = 1; leg < way.size(); leg++) {
      for (int percent = 0; percent <= 100; percent++) {
        var from = way.get(leg - 1).at();
        var at = from.plus(way.get(leg).at().minus(from).times(percent / 100.0));
        Crossing.regions(0)
            .forEach((name, region) -> {
              if (region.distanceMm(at) < RADIUS_MM) {
                assertThat(allowed).as("%s at %s", route, at).contains(name);
              }
            });
      }
    }
  }
}
