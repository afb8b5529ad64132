package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.stream.Collectors;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.random.Rng;

/**
 * The robots that a fault affects: {@code all}, including later ones; {@code any}, drawn when the
 * fault begins; {@code half} of them, drawn likewise; or names, {@code bot0+bot1}.
 *
 * @param named empty unless robots are named
 */
public record RobotSelector(Choice choice, List<RobotId> named) {

  /** The kind of selection. */
  public enum Choice {
    ALL,
    ANY,
    HALF,
    NAMED
  }

  public static final RobotSelector ALL = new RobotSelector(Choice.ALL, List.of());
  public static final RobotSelector ANY = new RobotSelector(Choice.ANY, List.of());
  public static final RobotSelector HALF = new RobotSelector(Choice.HALF, List.of());

  static final String EXPECTED = "a robot's name, names (bot0+bot1), any, half or all";

  public RobotSelector {
    named = List.copyOf(named);
    if (named.isEmpty() == (choice == Choice.NAMED)) {
      throw new IllegalArgumentException(choice + " of " + named + ": expected names or none");
    }
  }

  /** @throws BadInput if the text is in none of these forms */
  public static RobotSelector parse(String text) {
    return switch (text.strip()) {
      case "all" -> ALL;
      case "any" -> ANY;
      case "half" -> HALF;
      default -> names(text);
    };
  }

  private static RobotSelector names(String text) {
    List<RobotId> named = new ArrayList<>();
    for (String name : text.strip().split("\\+", -1)) {
      if (!RobotId.isValid(name.strip())) {
        throw new BadInput(BadInput.quote(text) + ": expected " + EXPECTED);
      }
      named.add(new RobotId(name.strip()));
    }
    return new RobotSelector(Choice.NAMED, named);
  }

  public boolean isAll() {
    return choice == Choice.ALL;
  }

  /**
   * The selected robots. {@code any} prefers a robot that is up; half of an odd number is rounded
   * down, but is at least one.
   *
   * @throws BadInput if a named robot has never joined
   */
  List<RobotId> pick(FaultTarget target, Rng rng) {
    return switch (choice) {
      case ALL -> target.robots();
      case ANY -> {
        List<RobotId> up = new ArrayList<>(target.robots());
        up.removeIf(robot -> !target.isUp(robot));
        yield drawn(up, 1, rng);
      }
      case HALF -> {
        List<RobotId> robots = new ArrayList<>(target.robots());
        yield drawn(robots, Math.max(1, robots.size() / 2), rng);
      }
      case NAMED -> {
        for (RobotId robot : named) {
          if (!target.isKnown(robot)) {
            throw new BadInput(unknownRobotMessage(robot, target.robots()));
          }
        }
        yield named;
      }
    };
  }

  /** The selected ends of links; named robots may join later. */
  List<RobotId> ends(FaultTarget target, Rng rng) {
    return choice == Choice.NAMED ? named : pick(target, rng);
  }

  static String unknownRobotMessage(RobotId robot, Collection<RobotId> known) {
    return "no robot is called " + robot + "; there are " + known;
  }

  private static List<RobotId> drawn(List<RobotId> from, int most, Rng rng) {
    List<RobotId> drawn = new ArrayList<>();
    while (drawn.size() < most && !from.isEmpty()) {
      drawn.add(from.remove(rng.nextInt(from.size())));
    }
    return drawn;
  }

  @Override
  public String toString() {
    return switch (choice) {
      case ALL -> "all";
      case ANY -> "any";
      case HALF -> "half";
      case NAMED -> named.stream().map(RobotId::name).collect(Collectors.joining("+"));
    };
  }
}
