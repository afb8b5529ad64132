package org.starl.robot.create;

import java.util.Arrays;
import java.util.Collections;
import java.util.EnumSet;
import java.util.LinkedHashSet;
import java.util.Set;

/**
 * What a {@link SimulatedCreate} moves and feels with: a body in a simulated world, or a test's. It
 * is called by one thread at a time.
 */
public interface CreateBody {

  /** The wheels turn so from {@code atNs} on, in mm/s of each wheel's rim. */
  void drive(double leftMmPerS, double rightMmPerS, long atNs);

  /** What there is to feel at {@code atNs}, which never runs backwards. */
  Senses senses(long atNs);

  /** What a sensor may say. */
  enum Sense {
    BUMP_LEFT,
    BUMP_RIGHT,
    DROP_LEFT,
    DROP_RIGHT,
    /** The third wheel's; Create 1 alone has its sensor. */
    CASTER_DROP,
    CLIFF_LEFT,
    CLIFF_FRONT_LEFT,
    CLIFF_FRONT_RIGHT,
    CLIFF_RIGHT,
    WALL,
    VIRTUAL_WALL,
    /** A charger with power is plugged in. */
    CHARGER
  }

  /**
   * What the body feels. Immutable.
   *
   * @param felt all of it; nothing else
   */
  record Senses(Set<Sense> felt, Battery battery) {

    /** On an open floor, with a full battery. */
    public static final Senses NOTHING = of();

    public Senses {
      Set<Sense> copy = EnumSet.noneOf(Sense.class);
      copy.addAll(felt);
      felt = Collections.unmodifiableSet(copy);
    }

    /** Nothing but these, with a full battery. */
    public static Senses of(Sense... felt) {
      return new Senses(new LinkedHashSet<>(Arrays.asList(felt)), Battery.FULL);
    }

    /** Nothing but these bump sensors. */
    public static Senses bumps(boolean left, boolean right) {
      Set<Sense> felt = EnumSet.noneOf(Sense.class);
      if (left) {
        felt.add(Sense.BUMP_LEFT);
      }
      if (right) {
        felt.add(Sense.BUMP_RIGHT);
      }
      return new Senses(felt, Battery.FULL);
    }

    /** Nothing but all wheels hanging down: the robot is lifted. */
    public static Senses lifted() {
      return of(Sense.DROP_LEFT, Sense.DROP_RIGHT, Sense.CASTER_DROP);
    }

    boolean has(Sense sense) {
      return felt.contains(sense);
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
   * @param chargeMah what is in it, in mAh
   * @param capacityMah what would fit
   */
  record Battery(int mv, int ma, int celsius, int chargeMah, int capacityMah) {
    /** Full, and slowly used. */
    public static final Battery FULL = new Battery(16_000, -300, 25, 2600, 2600);
  }
}
