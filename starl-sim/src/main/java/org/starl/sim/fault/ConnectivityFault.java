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

/** Blocks all datagrams between some robots, selected by name or by position. */
public sealed interface ConnectivityFault extends NetworkFault {

  /**
   * Groups that receive datagrams only from their own members: {@code
   * partition(bot0+bot1|bot2+bot3)}. All other robots form one more group.
   */
  record Groups(List<RobotSelector> groups) implements ConnectivityFault {

    public Groups {
      groups = List.copyOf(groups);
    }

    @Override
    public String name() {
      return "partition";
    }

    @Override
    public List<String> arguments() {
      return List.of(groups.stream().map(RobotSelector::toString).collect(Collectors.joining("|")));
    }

    @Override
    public List<RobotSelector> named() {
      return groups;
    }

    @Override
    public LinkRule rule(FaultContext onset) {
      List<List<RobotId>> robots = new ArrayList<>();
      for (int i = 0; i < groups.size(); i++) {
        robots.add(groups.get(i).pick(onset.ward(), onset.rng().fork("group" + i)));
      }
      return Partition.of(robots);
    }
  }

  /** One direction: {@code to} receives nothing from {@code from}: {@code partition(bot0>bot1)}. */
  record OneWay(RobotSelector from, RobotSelector to) implements ConnectivityFault {
    @Override
    public String name() {
      return "partition";
    }

    @Override
    public List<String> arguments() {
      return List.of(from + ">" + to);
    }

    @Override
    public List<RobotSelector> named() {
      return List.of(from, to);
    }

    @Override
    public LinkRule rule(FaultContext onset) {
      return Partition.oneWay(
          from.pick(onset.ward(), onset.rng().fork("from")),
          to.pick(onset.ward(), onset.rng().fork("to")));
    }
  }

  /**
   * Separates robots inside the area from robots outside it: {@code
   * partition(area=circle(0,0,2m))}.
   */
  record Area(Region area) implements ConnectivityFault {
    @Override
    public String name() {
      return "partition";
    }

    @Override
    public List<String> arguments() {
      return List.of("area=" + AreaText.write(area));
    }

    @Override
    public LinkRule rule(FaultContext onset) {
      return whileOnFloor(
          onset.ward(),
          "partition",
          (a, b) -> area.contains(a.pose().at()) == area.contains(b.pose().at()));
    }
  }

  /** The radio range, from centre to centre: {@code range(3m)}. */
  record Range(double mostMm) implements ConnectivityFault {
    @Override
    public String name() {
      return "range";
    }

    @Override
    public List<String> arguments() {
      return List.of(Quantities.distanceText(mostMm));
    }

    @Override
    public LinkRule rule(FaultContext onset) {
      return whileOnFloor(
          onset.ward(),
          "range",
          (a, b) -> {
            Point from = a.pose().at();
            return from.distanceMm(b.pose().at()) <= mostMm;
          });
    }
  }

  /** Datagrams need a line of sight without walls and bodies: {@code sight}. */
  record Sight() implements ConnectivityFault {
    @Override
    public String name() {
      return "sight";
    }

    @Override
    public List<String> arguments() {
      return List.of();
    }

    @Override
    public LinkRule rule(FaultContext onset) {
      return whileOnFloor(onset.ward(), "sight", onset.ward().world()::sees);
    }
  }

  /** Drops copies that {@code passes} rejects; robots off the floor have no position. */
  private static LinkRule whileOnFloor(
      FaultTarget ward, String why, BiPredicate<Body, Body> passes) {
    Verdict cut = Verdict.drop(why);
    return copy -> {
      Body from = ward.body(copy.from());
      Body to = ward.body(copy.to());
      return from == null || to == null || passes.test(from, to) ? Verdict.PASS : cut;
    };
  }
}
