package org.starl.robot.optitrack;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SortedMap;
import org.starl.geometry.Fix;
import org.starl.platform.Positioning;
import org.starl.robot.contract.Ground;
import org.starl.robot.contract.PositioningContract;
import org.starl.robot.contract.RealGround;

/** The contract, from a server over the loopback interface to a client. */
class NatNetPositioningTest extends PositioningContract {

  @Override
  protected Course newCourse() {
    return new NatNetCourse();
  }

  private static final class NatNetCourse implements Course {

    private final RealGround ground = new RealGround("robot");
    private final DrivingRobots robots = new DrivingRobots(ground.clock());
    private final Loopback loopback = new Loopback();
    private final NatNetServer server =
        loopback.serve(Loopback.server(), robots, robots.cameraClock);
    private final NatNetClient client =
        loopback.connect(server, NatNetSettings.unicast(Loopback.HOST), ground.clock());

    @Override
    public Ground ground() {
      return ground;
    }

    @Override
    public Positioning positioning(int robot) {
      return client.positioning(ground.strand(), "robot" + robot);
    }

    @Override
    public SortedMap<String, Fix> newest() {
      return client.newest();
    }

    @Override
    public void see(int robot, boolean isSeen) {
      robots.see(robot, isSeen);
    }

    @Override
    public void close() {
      client.close();
      server.close();
      ground.close();
      assertThat(loopback.failures).isEmpty();
      assertThat(client.statistics().dropped(FeedDrop.MALFORMED)).isZero();
    }
  }
}
