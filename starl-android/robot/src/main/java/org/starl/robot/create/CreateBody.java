package org.starl.robot.create;

import java.util.Arrays;
import java.util.Collections;
import java.util.EnumSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** The body of a {@link SimulatedCreate}, in a simulated world or in a test. One thread at a time. */
public interface CreateBody {

  /** A Create 2's light bumper, from left to right. */
  List<Sense> LIGHT_BUMPER =
      List.of(
          Sense.LIGHT_LEFT,
          Sense.LIGHT_FRONT_LEFT,
          Sense.LIGHT_CENTRE_LEFT,
          Sense.LIGHT_CENTRE_RIGHT,
          Sense.LIGHT_FRONT_RIGHT,
          Sense.LIGHT_RIGHT);

  /** From {@code atNs} on, the wheels' rims move at these speeds in mm/s. */
  void drive(double leftMmPerS, double rightMmPerS, long atNs);

  /** The sensors' values at {@code atNs}, which never decreases. */
  Senses senses(long atNs);

  /** Sensors that can be on. */
  enum Sense {
    BUMP_LEFT,
    BUMP_RIGHT,
    DROP_LEFT,
    DROP_RIGHT,
    /** Only a Create 1 has a sensor at its caster. */
    CASTER_DROP,
    CLIFF_LEFT,
    CLIFF_FRONT_LEFT,
    CLIFF_FRONT_RIGHT,
    CLIFF_RIGHT,
    WALL,
    VIRTUAL_WALL,
    LIGHT_LEFT,
    LIGHT_FRONT_LEFT,
    LIGHT_CENTRE_LEFT,
    LIGHT_CENTRE_RIGHT,
    LIGHT_FRONT_RIGHT,
    LIGHT_RIGHT,
    /** A charger with power is plugged in. */
    CHARGER
  }

  /**
   * The sensors' values. Immutable.
   *
   * @param active the sensors that are on
   */
  record Senses(Set<Sense> active, Battery battery) {

    /** On an open floor, with a full battery. */
    public static final Senses NOTHING = of();

    public Senses {
      Set<Sense> copy = EnumSet.noneOf(Sense.class);
      copy.addAll(active);
      active = Collections.unmodifiableSet(copy);
    }

    /** Only these are on; full battery. */
    public static Senses of(Sense... active) {
      return new Senses(new LinkedHashSet<>(Arrays.asList(active)), Battery.FULL);
    }

    /** Only these bump sensors are on. */
    public static Senses bumps(boolean left, boolean right) {
      Set<Sense> active = EnumSet.noneOf(Sense.class);
      if (left) {
        active.add(Sense.BUMP_LEFT);
      }
      if (right) {
        active.add(Sense.BUMP_RIGHT);
      }
      return new Senses(active, Battery.FULL);
    }

    /** These and the other's sensors are on; the battery is this one's. */
    public Senses and(Senses other) {
      Set<Sense> both = new LinkedHashSet<>(active);
      both.addAll(other.active);
      return new Senses(both, battery);
    }

    /** Only the wheel drops are on: the robot is lifted. */
    public static Senses lifted() {
      return of(Sense.DROP_LEFT, Sense.DROP_RIGHT, Sense.CASTER_DROP);
    }

    boolean has(Sense sense) {
      return active.contains(sense);
    }

    boolean anyCliff() {
      return has(Sense.CLIFF_LEFT)
          || has(Sense.CLIFF_FRONT_LEFT)
          || has(Sense.CLIFF_FRONT_RIGHT)
          || has(Sense.CLIFF_RIGHT);
    }
  }

  /**
   * The battery's state.
   *
   * @param mv voltage in mV
   * @param ma current in mA, negative out of the battery
   * @param celsius temperature
   * @param chargeMah charge in mAh
   * @param capacityMah capacity in mAh
   */
  record Battery(int mv, int ma, int celsius, int chargeMah, int capacityMah) {
    /** Full, with a small current. */
    public static final Battery FULL = new Battery(16_000, -300, 25, 2600, 2600);
  }
}
