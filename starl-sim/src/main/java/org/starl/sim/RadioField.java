package org.starl.sim;

import java.util.Arrays;
import java.util.BitSet;
import org.jspecify.annotations.Nullable;
import org.starl.sim.net.Coverage;
import org.starl.sim.net.Hearers;
import org.starl.sim.world.Body;
import org.starl.sim.world.Surroundings;
import org.starl.sim.world.World;

/**
 * The radios' limits by the true positions of bodies: the settings {@code radioRange} and {@code
 * radioSight}. A robot off the floor has no position: it hears all robots, and all hear it.
 */
final class RadioField implements Coverage {

  private final World world;
  private final Surroundings surroundings;
  private final double rangeMm;
  private final boolean needsSight;
  // By number; null while the robot is off the floor.
  private @Nullable Body[] bodies = new Body[16];
  private int numbers;
  private final BitSet offFloor = new BitSet();

  private RadioField(World world, double rangeMm, boolean needsSight) {
    this.world = world;
    this.surroundings = world.surroundings();
    this.rangeMm = rangeMm;
    this.needsSight = needsSight;
  }

  /** Null if the settings do not limit the range. */
  static @Nullable RadioField of(SimSettings settings, World world) {
    double rangeMm = settings.get(Setting.RADIO_RANGE);
    return rangeMm == 0 ? null : new RadioField(world, rangeMm, settings.get(Setting.RADIO_SIGHT));
  }

  /** Tells where a robot is: on the floor with this body, or off it. */
  void place(int number, @Nullable Body body) {
    if (number >= bodies.length) {
      bodies = Arrays.copyOf(bodies, 2 * number);
    }
    numbers = Math.max(numbers, number + 1);
    bodies[number] = body;
    offFloor.set(number, body == null);
  }

  @Override
  public String obstacle(int from, int to) {
    Body sender = bodies[from];
    Body recipient = bodies[to];
    if (sender == null || recipient == null) {
      return "";
    }
    if (sender.pose().at().distanceMm(recipient.pose().at()) > rangeMm) {
      return "range";
    }
    return needsSight && !world.sees(sender, recipient) ? "sight" : "";
  }

  @Override
  public void find(int from, Hearers hearers) {
    Body sender = bodies[from];
    if (sender == null) {
      for (int i = 0; i < numbers; i++) {
        hearers.add(i);
      }
      return;
    }
    int found = surroundings.find(sender, rangeMm, needsSight);
    for (int i = 0; i < found; i++) {
      hearers.add(surroundings.number(i));
    }
    for (int i = offFloor.nextSetBit(0); i >= 0; i = offFloor.nextSetBit(i + 1)) {
      hearers.add(i);
    }
  }
}
