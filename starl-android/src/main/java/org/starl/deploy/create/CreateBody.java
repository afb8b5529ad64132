package org.starl.deploy.create;

/**
 * What a {@link SimulatedCreate} moves and feels with: a body in a simulated world, or a test's. It
 * is called by one thread at a time.
 */
public interface CreateBody {

  /** The wheels turn so from {@code atNs} on, in mm/s of each wheel's rim. */
  void drive(double leftMmPerS, double rightMmPerS, long atNs);

  /** What there is to feel at {@code atNs}, which never runs backwards. */
  Senses senses(long atNs);

  /**
   * What the body feels. Immutable.
   *
   * @param casterDrop the third wheel's; Create 1 alone has its sensor
   * @param charger whether a charger with power is plugged in
   */
  record Senses(
      boolean bumpLeft,
      boolean bumpRight,
      boolean dropLeft,
      boolean dropRight,
      boolean casterDrop,
      boolean cliffLeft,
      boolean cliffFrontLeft,
      boolean cliffFrontRight,
      boolean cliffRight,
      boolean wall,
      boolean virtualWall,
      boolean charger,
      Battery battery) {

    /** On an open floor, with a full battery. */
    public static final Senses NOTHING = bumps(false, false);

    /** Nothing but these bump sensors. */
    public static Senses bumps(boolean left, boolean right) {
      return new Senses(
          left,
          right,
          false,
          false,
          false,
          false,
          false,
          false,
          false,
          false,
          false,
          false,
          Battery.FULL);
    }

    /** Nothing but all wheels hanging down: the robot is lifted. */
    public static Senses lifted() {
      return new Senses(
          false,
          false,
          true,
          true,
          true,
          false,
          false,
          false,
          false,
          false,
          false,
          false,
          Battery.FULL);
    }

    /** Nothing but a cliff at the front left. */
    public static Senses cliff() {
      return new Senses(
          false,
          false,
          false,
          false,
          false,
          false,
          true,
          false,
          false,
          false,
          false,
          false,
          Battery.FULL);
    }

    /** Nothing but a charger. */
    public static Senses charging() {
      return new Senses(
          false,
          false,
          false,
          false,
          false,
          false,
          false,
          false,
          false,
          false,
          false,
          true,
          Battery.FULL);
    }

    boolean anyCliff() {
      return cliffLeft || cliffFrontLeft || cliffFrontRight || cliffRight;
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
