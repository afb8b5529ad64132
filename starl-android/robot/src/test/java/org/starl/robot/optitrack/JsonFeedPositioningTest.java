package org.starl.robot.optitrack;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.SortedMap;
import org.starl.geometry.Fix;
import org.starl.platform.Positioning;
import org.starl.platform.Timer;
import org.starl.robot.contract.Ground;
import org.starl.robot.contract.PositioningContract;
import org.starl.robot.contract.RealGround;

/** The contract, from a strand that sends JSON lines over the loopback interface. */
class JsonFeedPositioningTest extends PositioningContract {

  private static final long PERIOD_NS = 10_000_000;

  /** On a busy machine the fastest datagram may take 100 ms to be read. */
  private static final FixBounds SLOW = new FixBounds(5, 0.02, 3, 80, 500, 4.3, 100, 30, 250, 0);

  @Override
  protected Course newCourse() {
    return new JsonCourse();
  }

  private static final class JsonCourse implements Course {

    private final RealGround ground = new RealGround("robot");
    private final RealGround system = new RealGround("system");
    private final DrivingRobots robots = new DrivingRobots(ground.clock());
    private final JsonFeed feed = new Loopback().listen(SLOW, ground.clock());
    private final Timer timer = system.timers().timer(this::measure);

    JsonCourse() {
      system.strand().post(this::measure);
    }

    private void measure() {
      timer.set(system.clock().nowNs() + PERIOD_NS);
      PoseSource.Snapshot snapshot = robots.snapshot();
      for (PoseSource.Body body : snapshot.bodies()) {
        if (body.isTracked()) {
          Loopback.send(line(body, snapshot.atNs()), feed.address());
        }
      }
    }

    private static byte[] line(PoseSource.Body body, long atNs) {
      return String.format(
              Locale.ROOT,
              "{\"robot\":\"%s\",\"xMm\":%.3f,\"yMm\":%.3f,\"headingRad\":0,\"errorMm\":1,"
                  + "\"atNs\":%d}\n",
              body.name(),
              body.pose().xMm(),
              body.pose().yMm(),
              atNs)
          .getBytes(StandardCharsets.US_ASCII);
    }

    @Override
    public Ground ground() {
      return ground;
    }

    @Override
    public Positioning positioning(int robot) {
      return feed.positioning(ground.strand(), "robot" + robot);
    }

    @Override
    public SortedMap<String, Fix> newest() {
      return feed.newest();
    }

    @Override
    public void see(int robot, boolean isSeen) {
      robots.see(robot, isSeen);
    }

    @Override
    public void close() {
      system.close();
      feed.close();
      ground.close();
    }
  }
}
