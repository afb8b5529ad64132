package org.starl.workload;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.apps.Parameter;
import org.starl.apps.Request;
import org.starl.comms.Codec;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;
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
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;

/**
 * {@code starl campaign geocast}: robots drive to and fro and send to areas of all shapes, and every
 * other time to everybody.
 */
final class GeocastWorkload extends PrimitiveDemo {

  private static final String XID = "news";
  private static final long THINK_MS = 500;
  private static final double REACH_MM = 900;
  private static final long LEAST_D_MS = 100;
  private static final long MOST_D_MS = 2_000;

  /** Robots may know their places worse, and then owe nothing. */
  private static final double POSITION_ERROR_MM = 50;

  /** Clocks that are up to 200 ppm off differ by no more after two minutes. */
  private static final long CLOCK_SKEW_NS = 50_000_000;

  GeocastWorkload() {
    super("geocast", "robots on their way send to areas of all shapes, and to everybody");
  }

  @Override
  public Envelope envelope() {
    return Envelope.SPATIAL;
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(rounds(12), busy("20s"));
  }

  @Override
  void prepare(Simulation.Builder simulation, Request request, SimSettings settings) {
    Course course = course(request);
    int robots = count(request, 1, 64);
    double sideMm = SPACING_MM * Math.ceil(Math.sqrt(robots));
    place(simulation, settings, robots, gvh -> new Herald(gvh, course, sideMm));
    simulation.monitor(() -> new GeocastSpec(POSITION_ERROR_MM, CLOCK_SKEW_NS));
  }

  private static final class Herald extends Client {
    private static final Codec<Integer> CODEC =
        new Codec<>() {
          @Override
          public void write(Integer message, WireWriter out) {
            out.i32(message);
          }

          @Override
          public Integer read(WireReader in) {
            return in.i32();
          }
        };

    private final double sideMm;
    private final Geocast<Integer> geocast;
    private final Broadcast<Integer> broadcast;

    Herald(GlobalVarHolder gvh, Course course, double sideMm) {
      super(gvh, course, THINK_MS);
      this.sideMm = sideMm;
      GeocastSettings d = GeocastSettings.DEFAULT;
      GeocastSettings settings =
          new GeocastSettings(d.resendMs(), d.maxResendMs(), CLOCK_SKEW_NS, d.openMembership());
      geocast = new Geocast<>(gvh, XID, CODEC, (origin, message) -> {}, settings);
      broadcast = new Broadcast<>(gvh, XID, CODEC, (origin, message) -> {}, settings);
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
    }

    @Override
    protected boolean obtain(int round) {
      long dMs = rng.nextLong(LEAST_D_MS, MOST_D_MS);
      GeocastReceipt receipt =
          round % 2 == 0 ? geocast.do_geocast(round, area(), dMs) : broadcast.BCast(round, dMs);
      await(receipt::isComplete);
      return true;
    }

    private Region area() {
      Point at = new Point(sideMm * rng.nextDouble(), sideMm * rng.nextDouble());
      double sizeMm = SPACING_MM * (0.3 + rng.nextDouble());
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
}
