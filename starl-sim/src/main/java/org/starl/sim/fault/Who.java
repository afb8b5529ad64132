package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.starl.RobotId;
import org.starl.random.Rng;
import org.starl.sim.input.BadInput;

/**
 * Whom a fault befalls: {@code all}, those who come later included; {@code any}, one that is drawn
 * when the fault begins; or names, {@code bot0+bot1}.
 *
 * @param isAny whether one is drawn
 * @param named empty for all and any
 */
public record Who(boolean isAny, List<RobotId> named) {

  public static final Who ALL = new Who(false, List.of());
  public static final Who ANY = new Who(true, List.of());

  static final String EXPECTED = "a robot's name, names (bot0+bot1), any or all";

  public Who {
    named = List.copyOf(named);
    if (isAny && !named.isEmpty()) {
      throw new IllegalArgumentException("any of " + named + ": expected any of all");
    }
  }

  public static Who of(RobotId... robots) {
    return new Who(false, List.of(robots));
  }

  /** @throws BadInput if it is none of the above */
  public static Who parse(String text) {
    String stripped = text.strip();
    if (stripped.equals("all")) {
      return ALL;
    }
    if (stripped.equals("any")) {
      return ANY;
    }
    List<RobotId> named = new ArrayList<>();
    for (String name : stripped.split("\\+", -1)) {
      if (!RobotId.isValid(name.strip())) {
        throw new BadInput(BadInput.quote(text) + ": expected " + EXPECTED);
      }
      named.add(new RobotId(name.strip()));
    }
    return new Who(false, named);
  }

  public boolean isAll() {
    return !isAny && named.isEmpty();
  }

  /**
   * The robots that it means now; with {@code any} one of those that are up, if there is one.
   *
   * @throws BadInput if a named robot never was there
   */
  List<RobotId> pick(Ward ward, Rng rng) {
    if (isAny) {
      List<RobotId> up = new ArrayList<>(ward.robots());
      up.removeIf(robot -> !ward.isUp(robot));
      return up.isEmpty() ? List.of() : List.of(up.get(rng.nextInt(up.size())));
    }
    if (named.isEmpty()) {
      return ward.robots();
    }
    for (RobotId robot : named) {
      if (!ward.isKnown(robot)) {
        throw new BadInput("no robot is called " + robot + "; there are " + ward.robots());
      }
    }
    return named;
  }

  @Override
  public String toString() {
    if (named.isEmpty()) {
      return isAny ? "any" : "all";
    }
    return named.stream().map(RobotId::name).collect(Collectors.joining("+"));
  }
}
