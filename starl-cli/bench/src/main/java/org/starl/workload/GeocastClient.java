package org.starl.workload;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.apps.Request;
import org.starl.geometry.Circle;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Region;
import org.starl.primitives.geocast.Broadcast;
import org.starl.primitives.geocast.Geocast;
import org.starl.primitives.geocast.GeocastReceipt;
import org.starl.primitives.geocast.GeocastSettings;
import org.starl.primitives.geocast.GeocastSpec;
import org.starl.shape.Shapes;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.time.Time;

/** Robots drive about and send to areas of all shapes and, every other time, to all robots. */
final class GeocastClient extends Client {

  private static final String XID = "news";
  private static final long THINK_MS = 500;
  private static final double REACH_MM = 900;
  private static final long MIN_D_MS = 100;
  static final long MAX_D_MS = 2_000;

  /** A receipt is complete at the end of the interval, or before. */
  private static final long PROMPT_MS = MAX_D_MS + 1;

  /** With a larger position error a robot owes nothing. */
  private static final double POSITION_ERROR_MM = 50;

  /** Maximum difference, after two minutes, of clocks that are up to 200 ppm off. */
  private static final long CLOCK_SKEW_NS = 50 * Time.NS_PER_MS;

  private static final GeocastSettings SETTINGS =
      GeocastSettings.DEFAULT.withClockSkewNs(CLOCK_SKEW_NS);

  /** When the default settings repeat a copy, from the second one on. */
  private static final List<Long> COPIES_MS = List.of(100L, 250L, 475L, 812L, 1_318L);

  /** How often a robot sends so many at once that receivers forget those that are over. */
  private static final double MANY = 0.02;

  private static final int MANY_CASTS = 80;
  private static final long MANY_D_MS = 300;

  /** An interval that ends so soon after a copy may end before the copy arrives, or just after. */
  private static final long LAST_COPY_MS = 60;

  /** How often another geocast is under way when a robot sends one, and for how long at most. */
  private static final double BEFORE = 0.25;

  private static final long BEFORE_MS = 300;

  private final double sideMm;
  private final boolean endsWithCopies;
  private final Geocast<Integer> geocast;
  private final Broadcast<Integer> broadcast;

  private GeocastClient(GlobalVarHolder gvh, Setup setup) {
    super(gvh, setup, THINK_MS);
    sideMm = setup.sideMm();
    endsWithCopies = setup.course().isCalm();
    geocast = new Geocast<>(gvh, XID, Shapes.INT, (origin, message) -> {}, SETTINGS);
    broadcast = new Broadcast<>(gvh, XID, Shapes.INT, (origin, message) -> {}, SETTINGS);
  }

  static void setUp(Setup setup) {
    setup.place(gvh -> new GeocastClient(gvh, setup));
    long delayNs = setup.isLossless() ? setup.delayNs() : GeocastSpec.NEVER;
    setup
        .simulation()
        .monitor(() -> new GeocastSpec(POSITION_ERROR_MM, SETTINGS, delayNs).answering());
    setup.promise(PROMPT_MS, 0, false);
  }

  /** Fixes with errors, so that robots near a border are uncertain. */
  static void settings(Request request, SimSettings.Builder settings) {
    settings.set(Setting.POSITION_NOISE, 20.0);
  }

  @Override
  protected void prepare() {
    await(gvh.gps::hasFix);
    if (!gvh.plat.moat.inMotion()) {
      double angle = 2 * Math.PI * rng.nextDouble();
      double xMm = gvh.gps.pose().xMm() + REACH_MM * StrictMath.cos(angle);
      double yMm = gvh.gps.pose().yMm() + REACH_MM * StrictMath.sin(angle);
      gvh.plat.moat.doMove(new ItemPosition("somewhere", xMm, yMm));
    }
    if (rng.nextBoolean(BEFORE)) {
      geocast.do_geocast(-1, area(), MAX_D_MS);
      pause(rng.nextLong(0, BEFORE_MS));
    }
  }

  @Override
  protected boolean obtain(int round) {
    long dMs = rng.nextLong(MIN_D_MS, MAX_D_MS);
    if (endsWithCopies && rng.nextBoolean(0.5)) {
      dMs = COPIES_MS.get(rng.nextInt(COPIES_MS.size())) + rng.nextLong(0, LAST_COPY_MS);
    }
    int more = rng.nextBoolean(MANY) ? MANY_CASTS : 0;
    for (int i = 0; i < more; i++) {
      broadcast.BCast(i, MANY_D_MS);
    }
    GeocastReceipt receipt =
        round % 2 == 0 ? geocast.do_geocast(round, area(), dMs) : broadcast.BCast(round, dMs);
    await(receipt::isComplete);
    return true;
  }

  private Region area() {
    Point at = new Point(sideMm * rng.nextDouble(), sideMm * rng.nextDouble());
    double sizeMm = Setup.SPACING_MM * (0.3 + rng.nextDouble());
    return switch (rng.nextInt(3)) {
      case 0 -> new Circle(at, sizeMm);
      case 1 -> new Rectangle(at.xMm(), at.yMm(), at.xMm() + sizeMm, at.yMm() + 2 * sizeMm);
      default ->
          new Polygon(
              List.of(
                  at,
                  new Point(at.xMm() + 2 * sizeMm, at.yMm()),
                  new Point(at.xMm(), at.yMm() + sizeMm)));
    };
  }
}
