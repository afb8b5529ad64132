package org.starl.android.app;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.Locale;
import java.util.function.Consumer;
import org.starl.deploy.create.ByteLink;
import org.starl.deploy.create.CreateModel;
import org.starl.deploy.create.CreateSettings;
import org.starl.deploy.create.SocketLink;
import org.starl.deploy.file.Limits;
import org.starl.deploy.file.Network;
import org.starl.deploy.file.Positions;
import org.starl.deploy.file.RobotEntry;
import org.starl.deploy.file.Wheels;
import org.starl.deploy.optitrack.Axes;
import org.starl.deploy.optitrack.BodyAxis;
import org.starl.deploy.optitrack.FixBounds;
import org.starl.deploy.optitrack.JsonFeed;
import org.starl.deploy.optitrack.JsonFeedSettings;
import org.starl.deploy.optitrack.NatNetClient;
import org.starl.deploy.optitrack.NatNetSettings;
import org.starl.deploy.optitrack.PoseFeed;
import org.starl.deploy.optitrack.UpAxis;
import org.starl.deploy.udp.UdpRadio;
import org.starl.motion.MotionParameters;
import org.starl.platform.Clock;
import org.starl.platform.LogSink;
import org.starl.platform.Strand;

/** Makes a robot's ports as its deployment says. */
final class Ports {

  /** Wheels on a floor turn a body a little more than commanded; measured robots stay below this. */
  private static final double SPEED_ERROR = 0.1;

  /** A step of the automaton that is late, Bluetooth, the chassis' own period, and braking. */
  private static final long REACTION_MS = 200;

  private Ports() {}

  static UdpRadio radio(Mission mission, Strand strand, Consumer<IOException> onFailure)
      throws IOException {
    Network network = mission.deployment().network();
    RobotEntry self = mission.robot();
    int port = self.address() == null ? network.port() : self.address().port();
    UdpRadio radio = UdpRadio.open(self.id(), strand, new InetSocketAddress(port), onFailure);
    try {
      for (RobotEntry robot : mission.deployment().robots().values()) {
        if (robot.address() != null) {
          radio.setPeer(robot.id(), robot.address().resolve());
        }
      }
      return radio;
    } catch (IOException e) {
      radio.close();
      throw e;
    }
  }

  static PoseFeed feed(Mission mission, Clock clock, LogSink log) throws IOException {
    Limits limits = mission.deployment().limits();
    Positions positions = mission.deployment().positions();
    if (positions instanceof Positions.NatNet natNet) {
      UpAxis up = natNet.isYUp() ? UpAxis.Y : UpAxis.Z;
      String group = natNet.multicast();
      NatNetSettings settings =
          NatNetSettings.unicast(InetAddress.getLoopbackAddress())
              .withServer(natNet.server().resolve())
              .withGroup(
                  group == null
                      ? null
                      : new InetSocketAddress(InetAddress.getByName(group), natNet.dataPort()))
              .withAxes(new Axes(up, BodyAxis.PLUS_X))
              .withBounds(bounds(natNet.errorMm(), natNet.errorRad(), limits));
      return NatNetClient.open(settings, clock, log);
    }
    if (positions instanceof Positions.JsonFeed json) {
      JsonFeedSettings settings =
          new JsonFeedSettings(
              new InetSocketAddress(json.port()),
              null,
              bounds(json.errorMm(), json.errorRad(), limits));
      return JsonFeed.open(settings, clock, log);
    }
    throw new IllegalStateException("a mission without a measuring system");
  }

  private static FixBounds bounds(double errorMm, double errorRad, Limits limits) {
    FixBounds usual = FixBounds.DEFAULT;
    return new FixBounds(
        errorMm,
        errorRad,
        usual.errorScale(),
        usual.markerSpreadMm(),
        Math.min(usual.maxSpeedMmPerS(), limits.speedMmPerS()) * (1 + SPEED_ERROR),
        usual.maxTurnRadPerS(),
        usual.maxDelayMs(),
        usual.maxLatencyMs(),
        usual.maxAgeMs());
  }

  static CreateSettings create(Mission mission) {
    Wheels.Create wheels = (Wheels.Create) mission.robot().wheels();
    Limits limits = mission.deployment().limits();
    CreateModel model =
        wheels.model().toLowerCase(Locale.ROOT).equals("create1")
            ? CreateModel.CREATE_1
            : CreateModel.CREATE_2;
    CreateSettings usual = CreateSettings.of(model);
    return new CreateSettings(
        model,
        usual.mode(),
        limits.watchdogMs(),
        limits.positionMs(),
        usual.sensorTimeoutMs(),
        usual.recoverAfterMs(),
        usual.linkTimeoutMs(),
        usual.retryMs(),
        (int) limits.speedMmPerS());
  }

  static MotionParameters motion(Limits limits) {
    MotionParameters usual = MotionParameters.DEFAULT;
    double most = limits.speedMmPerS();
    return usual.toBuilder()
        .linSpeedMaxMmPerS(Math.min(usual.linSpeedMaxMmPerS(), most))
        .linSpeedMinMmPerS(Math.min(usual.linSpeedMinMmPerS(), most))
        .arcSpeedMaxMmPerS(Math.min(usual.arcSpeedMaxMmPerS(), most))
        .speedError(SPEED_ERROR)
        .reactionMs(REACTION_MS)
        .build();
  }

  /** Links over TCP, for a Create behind a serial server. */
  static ByteLink.Source tcp(Wheels.Tcp tcp) {
    return SocketLink.to(tcp.address().host(), tcp.address().port());
  }
}
