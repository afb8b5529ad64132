package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiPredicate;
import java.util.stream.Collectors;
import org.starl.geometry.Point;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.input.Quantities;
import org.starl.sim.net.LinkRule;
import org.starl.sim.net.Partition;
import org.starl.sim.net.Verdict;
import org.starl.sim.world.Body;

/** Nothing gets through between some robots, by who or where they are. */
public sealed interface Cut extends AirHarm {

  /**
   * Groups that hear only their own: {@code partition(bot0+bot1|bot2+bot3)}; everybody else is one
   * more. With one group it is that group against the others.
   */
  record Groups(List<Who> groups) implements Cut {

    public Groups {
      groups = List.copyOf(groups);
    }

    @Override
    public String name() {
      return "partition";
    }

    @Override
    public List<String> arguments() {
      return List.of(groups.stream().map(Who::toString).collect(Collectors.joining("|")));
    }

    @Override
    public List<Who> named() {
      return groups;
    }

    @Override
    public LinkRule rule(Onset onset) {
      List<List<RobotId>> robots = new ArrayList<>();
      for (int i = 0; i < groups.size(); i++) {
        robots.add(groups.get(i).pick(onset.ward(), onset.rng().fork("group" + i)));
      }
      return Partition.of(robots);
    }
  }

  /** Nothing from these reaches those: {@code partition(bot0>bot1)}. */
  record OneWay(Who from, Who to) implements Cut {
    @Override
    public String name() {
      return "partition";
    }

    @Override
    public List<String> arguments() {
      return List.of(from + ">" + to);
    }

    @Override
    public List<Who> named() {
      return List.of(from, to);
    }

    @Override
    public LinkRule rule(Onset onset) {
      return Partition.oneWay(
          from.pick(onset.ward(), onset.rng().fork("from")),
          to.pick(onset.ward(), onset.rng().fork("to")));
    }
  }

  /** Whoever stands in the area, against the others: {@code partition(area=circle(0,0,2m))}. */
  record Area(Region area) implements Cut {
    @Override
    public String name() {
      return "partition";
    }

    @Override
    public List<String> arguments() {
      return List.of("area=" + AreaText.write(area));
    }

    @Override
    public LinkRule rule(Onset onset) {
      return whileOnFloor(
          onset.ward(),
          "partition",
          (a, b) -> area.contains(a.pose().at()) == area.contains(b.pose().at()));
    }
  }

  /** Nothing carries farther, from centre to centre: {@code range(3m)}. */
  record Range(double mostMm) implements Cut {
    @Override
    public String name() {
      return "range";
    }

    @Override
    public List<String> arguments() {
      return List.of(Quantities.distanceText(mostMm));
    }

    @Override
    public LinkRule rule(Onset onset) {
      return whileOnFloor(
          onset.ward(),
          "range",
          (a, b) -> {
            Point from = a.pose().at();
            return from.distanceMm(b.pose().at()) <= mostMm;
          });
    }
  }

  /** Nothing passes through walls or bodies: {@code sight}. */
  record Sight() implements Cut {
    @Override
    public String name() {
      return "sight";
    }

    @Override
    public List<String> arguments() {
      return List.of();
    }

    @Override
    public LinkRule rule(Onset onset) {
      return whileOnFloor(onset.ward(), "sight", onset.ward().world()::sees);
    }
  }

  /** Drops what {@code passes} does not let through; who is not on the floor is nowhere. */
  private static LinkRule whileOnFloor(Ward ward, String why, BiPredicate<Body, Body> passes) {
    Verdict cut = Verdict.drop(why);
    return copy -> {
      Body from = ward.body(copy.from());
      Body to = ward.body(copy.to());
      return from == null || to == null || passes.test(from, to) ? Verdict.PASS : cut;
    };
  }
}
