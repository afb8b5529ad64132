package org.starl.primitives.geocast;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.primitives.geocast.GeocastWorld.MS;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.geometry.Circle;
import org.starl.geometry.Everywhere;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Region;
import org.starl.geometry.Union;
import org.starl.primitives.geocast.GeocastWorld.Mutant;
import org.starl.primitives.geocast.GeocastWorld.Robot;
import org.starl.random.Rng;
import org.starl.spec.SpecReport;

class GeocastAdversaryTest {

  private static final int ROBOTS = 6;
  private static final long END_NS = 20_000 * MS;

  @Property(tries = 300)
  void theContractHoldsInTheWholeEnvelope(@ForAll long seed) {
    Rng rng = new Rng(seed);
    SpecReport report = run(rng, 60 * rng.nextDouble(), rng.nextLong(0, 50 * MS), Mutant.NONE);
    assertThat(report.violations()).isEmpty();
  }

  @Test
  void aRobotOutsideOwesNothingEvenWithExactPositions() {
    for (long seed = 0; seed < 20; seed++) {
      assertThat(run(new Rng(seed), 0.001, 0, Mutant.NONE).violations()).isEmpty();
    }
  }

  /** Most runs deliver messages; in a few the network is too bad. */
  @Test
  void theWorldsDeliverMessages() {
    int runsWithDeliveries = 0;
    for (long seed = 0; seed < 40; seed++) {
      SpecReport report = run(new Rng(seed), 10, 0, Mutant.NONE);
      if (report.checks(GeocastSpec.EXCLUSION) > 0) {
        runsWithDeliveries++;
        assertThat(report.checks(GeocastSpec.ONCE)).isPositive();
        assertThat(report.checks(GeocastSpec.DEADLINE)).isPositive();
      }
    }
    assertThat(runsWithDeliveries).isGreaterThan(30);
  }

  @ParameterizedTest
  @CsvSource({
    "IGNORES_AREA, geocast.exclusion",
    "IGNORES_DEADLINE, geocast.deadline",
    "DELIVERS_TWICE, geocast.once",
    "NEVER_DELIVERS, geocast.inclusion",
    "IGNORES_AREA, Geocast_decls",
    "IGNORES_DEADLINE, Geocast_decls",
    "DELIVERS_TWICE, Geocast_decls"
  })
  void aWrongImplementationIsFound(Mutant mutant, String lemma) {
    long found = 0;
    for (long seed = 0; seed < 40; seed++) {
      SpecReport report = run(new Rng(seed), 10, 0, mutant);
      found += report.violations(lemma);
      assertThat(report.lemmas()).contains(lemma);
    }
    assertThat(found).isPositive();
  }

  @Test
  void allRobotsDeliverABroadcastInAGoodNetworkWithoutPositions() {
    GeocastWorld world = new GeocastWorld(1, ROBOTS, 0, 0, Mutant.NONE);
    world.at(0, () -> world.robot(0).geocast("m", new Everywhere(), 1_000 * MS));
    world.runUntil(END_NS);
    for (int i = 1; i < ROBOTS; i++) {
      assertThat(world.robot(i).delivered).containsExactly("m");
    }
    assertThat(world.robot(0).delivered).isEmpty();
    assertThat(world.robot(0).copiesSent).isEqualTo(1);
    assertThat(world.robot(0).isComplete()).isTrue();
  }

  @Test
  void copiesPassANetworkThatLosesMostOfThem() {
    GeocastWorld world = new GeocastWorld(1, ROBOTS, 0, 0, Mutant.NONE);
    world.network(0.7, 0, 10 * MS);
    world.at(0, () -> world.robot(0).geocast("m", new Everywhere(), 19_000 * MS));
    world.runUntil(END_NS);
    for (int i = 1; i < ROBOTS; i++) {
      assertThat(world.robot(i).delivered).containsExactly("m");
    }
  }

  @Test
  void inAGoodNetworkInclusionIsOwedToExactlyThoseInside() {
    GeocastWorld world = new GeocastWorld(1, 4, 10, 0, Mutant.NONE);
    Region area = new Circle(new Point(0, 0), 1_000);
    world.at(
        0,
        () -> {
          world.robot(0).join(5_000, 0);
          world.robot(1).join(0, 0);
          world.robot(2).join(979, 0);
          world.robot(3).join(1_011, 0);
          world.robot(0).geocast("m", area, 1_000 * MS);
        });
    SpecReport report = world.runUntil(END_NS);
    assertThat(world.robot(1).delivered).containsExactly("m");
    assertThat(world.robot(2).delivered).containsExactly("m");
    assertThat(world.robot(3).delivered).isEmpty();
    assertThat(report.checks(GeocastSpec.INCLUSION)).isEqualTo(2);
    assertThat(report.violations()).isEmpty();
  }

  private static SpecReport run(Rng rng, double errorMm, long skewNs, Mutant mutant) {
    GeocastWorld world = new GeocastWorld(rng.nextLong(), ROBOTS, errorMm, skewNs, mutant);
    world.network(rng.nextDouble() * 0.6, 0.3, rng.nextLong(1, 1_500) * MS);
    world.at(
        0,
        () -> {
          for (int i = 0; i < ROBOTS; i++) {
            world.robot(i).join(coordinate(rng), coordinate(rng));
          }
        });
    for (int i = 0; i < 60; i++) {
      Robot robot = world.robot(rng.nextInt(ROBOTS));
      long timeNs = rng.nextLong(1, END_NS);
      double heading = 6 * rng.nextDouble();
      double speed = rng.nextBoolean(0.3) ? 0 : 500 * rng.nextDouble();
      double turn = rng.nextBoolean(0.5) ? 0 : 2 * rng.nextDouble() - 1;
      world.at(timeNs, () -> robot.drive(heading, speed, turn));
    }
    for (int i = 0; i < 8; i++) {
      Robot robot = world.robot(rng.nextInt(ROBOTS));
      Region area = region(rng);
      long dNs = rng.nextLong(100, 4_000) * MS;
      String message = "m" + i;
      world.at(rng.nextLong(1, END_NS), () -> robot.geocast(message, area, dNs));
    }
    return world.runUntil(END_NS);
  }

  private static Region region(Rng rng) {
    Point center = new Point(coordinate(rng), coordinate(rng));
    Region circle = new Circle(center, 200 + 1_500 * rng.nextDouble());
    return switch (rng.nextInt(4)) {
      case 0 -> circle;
      case 1 -> Rectangle.around(center, 2_000, 1_000);
      case 2 ->
          Polygon.of(
              center, center.plus(new Point(2_000, 300)), center.plus(new Point(500, 2_500)));
      default -> Union.of(circle, new Rectangle(0, 0, 700, 700));
    };
  }

  private static double coordinate(Rng rng) {
    return 4_000 * rng.nextDouble() - 2_000;
  }
}
