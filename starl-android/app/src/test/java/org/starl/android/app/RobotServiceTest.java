package org.starl.android.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.robolectric.Shadows.shadowOf;

import android.Manifest;
import android.app.Application;
import android.app.Notification;
import android.bluetooth.BluetoothAdapter;
import android.bluetooth.BluetoothDevice;
import android.content.ComponentName;
import android.content.Intent;
import android.content.pm.ServiceInfo;
import android.os.Looper;
import android.os.Process;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import java.util.SortedMap;
import java.util.UUID;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.android.controller.ServiceController;
import org.robolectric.annotation.Config;
import org.robolectric.shadows.ShadowPowerManager;
import org.robolectric.shadows.ShadowProcess;
import org.starl.android.app.RobotService.Phase;
import org.starl.apps.Demo;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.intersection.IntersectionDemo;
import org.starl.apps.lightpaint.LightPaintDemo;
import org.starl.apps.maze.MazeDemo;
import org.starl.apps.race.RaceDemo;
import org.starl.apps.search.SearchDemo;
import org.starl.geometry.Pose;
import org.starl.robot.create.CreateHold;
import org.starl.robot.optitrack.NatNetServer;
import org.starl.robot.optitrack.PoseSource;
import org.starl.robot.realtime.RealClock;

/** The service: what it asks of Android, and whole runs of a robot behind the Bluetooth socket. */
@RunWith(RobolectricTestRunner.class)
@Category(TakesLong.class)
@Config(
    sdk = 37,
    shadows = {AdapterShadow.class, SocketShadow.class, BinderShadow.class})
public final class RobotServiceTest {

  private static final long LIMIT_S = 60;

  private final RealClock clock = new RealClock();
  private SimulatedCar car = new SimulatedCar("bot0", new Pose(0, 0, 0), clock, event -> {});
  private final List<SocketShadow> sockets = new CopyOnWriteArrayList<>();
  private final List<UUID> services = new CopyOnWriteArrayList<>();
  private final AtomicInteger refusals = new AtomicInteger();
  private final Application application = RuntimeEnvironment.getApplication();

  /** Blocks the service's worker while a test holds it. */
  private final Semaphore mayGoOn = new Semaphore(0);

  private NatNetServer cameras;
  private ServiceController<WheelsService> wheels;
  private ServiceController<RobotService> controller;
  private RobotService service;

  @Before
  public void pairAndLoad() throws IOException {
    shadowOf(application)
        .grantPermissions(Manifest.permission.BLUETOOTH_CONNECT, Permissions.ACCESS_LOCAL_NETWORK);
    BluetoothAdapter adapter = BluetoothLinks.adapter(application);
    shadowOf(adapter).setEnabled(true);
    BluetoothDevice device = adapter.getRemoteDevice("00:06:66:12:34:56");
    shadowOf(adapter).setBondedDevices(Set.of(device));
    AdapterShadow.serve(this::connected, services::add);
    cameras =
        NatNetServer.open(
            SimulatedCar.CAMERAS,
            () -> new PoseSource.Snapshot(clock.nowNs(), List.of(car.asSeen())),
            clock,
            failure -> {});
    load(deployment("hello"));
    wheels = Robolectric.buildService(WheelsService.class).create();
    shadowOf(application)
        .setComponentNameAndServiceForBindService(
            new ComponentName(application, WheelsService.class), wheels.get().onBind(new Intent()));
    controller = Robolectric.buildService(RobotService.class).create();
    service = controller.get();
  }

  @After
  public void endAll() throws Exception {
    mayGoOn.release();
    refusals.set(0);
    // A link that is being opened would be opened in the next test.
    until(() -> !isHeldBy(CreateHold.NO_LINK));
    controller.destroy();
    RobotService.WORKER.submit(() -> {}).get(LIMIT_S, TimeUnit.SECONDS);
    wheels.destroy();
    cameras.close();
    car.close();
  }

  private void connected(String address, SocketShadow socket) throws IOException {
    if (refusals.getAndDecrement() > 0) {
      throw new IOException("read failed, socket might closed or timeout");
    }
    if (ShadowProcess.wasKilled(Process.myPid())) {
      // As the kernel does for a process that was killed.
      sockets.get(sockets.size() - 1).cut();
    }
    sockets.add(socket);
    car.serve(socket.getOutputStreamSink(), socket.getInputStreamFeeder());
  }

  private String deployment(String app) throws IOException {
    try (DatagramSocket free = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      return String.join(
          "\n",
          "app: " + app,
          "network: {broadcasts: no}",
          "positions: {source: natnet, server: \"127.0.0.1:" + cameras.address().getPort() + "\"}",
          "robots:",
          "  bot0:",
          "    address: \"127.0.0.1:" + free.getLocalPort() + "\"",
          "    chassis: {kind: create, model: create1, port: \"bluetooth:"
              + AdapterShadow.NAME
              + "\"}",
          "");
    }
  }

  private void load(String deployment) throws IOException {
    Store store = new Store(application);
    store.load(
        Store.Item.DEPLOYMENT,
        new ByteArrayInputStream(deployment.getBytes(StandardCharsets.UTF_8)));
    store.setRobotName("bot0");
  }

  private void tell(String action) {
    service.onStartCommand(RobotService.intent(application, action), 0, 1);
  }

  private void until(BooleanSupplier isSo) throws InterruptedException {
    car.until(() -> {
      shadowOf(Looper.getMainLooper()).idle();
      return isSo.getAsBoolean();
    });
  }

  /** Starts a robot whose opening blocks, and returns during the opening. */
  private void startHeld(RobotService.Opener then) throws InterruptedException {
    Semaphore isOpening = new Semaphore(0);
    service.opener =
        (mission, links, files, log, onBug) -> {
          isOpening.release();
          mayGoOn.acquireUninterruptibly();
          return then.open(mission, links, files, log, onBug);
        };
    tell(RobotService.START);
    until(isOpening::tryAcquire);
    service.opener = Robot::open;
  }

  /** Releases the worker; returns when it has completed and reported all requests. */
  private void goOn() throws Exception {
    mayGoOn.release();
    RobotService.WORKER.submit(() -> {}).get(LIMIT_S, TimeUnit.SECONDS);
    shadowOf(Looper.getMainLooper()).idle();
  }

  private boolean isHeldBy(CreateHold hold) {
    RobotStatus status = service.status();
    return status != null && status.wheels().holds().contains(hold);
  }

  @Test
  public void theForegroundServiceKeepsThePhoneAwake() throws InterruptedException {
    tell(RobotService.START);
    Notification notification = shadowOf(service).getLastForegroundNotification();
    assertThat(notification.getChannelId()).isEqualTo(RobotNotification.CHANNEL);
    assertThat(notification.actions)
        .extracting(action -> action.title.toString())
        .contains("Emergency stop");
    assertThat(service.getForegroundServiceType())
        .isEqualTo(ServiceInfo.FOREGROUND_SERVICE_TYPE_CONNECTED_DEVICE);
    assertThat(ShadowPowerManager.getLatestWakeLock().isHeld()).isTrue();
    assertThat(service.holdsLocks()).isTrue();
    until(() -> service.phase() == Phase.RUNNING);
    tell(RobotService.STOP);
    until(() -> !service.holdsLocks());
    assertThat(ShadowPowerManager.getLatestWakeLock().isHeld()).isFalse();
    assertThat(shadowOf(service).isForegroundStopped()).isTrue();
    assertThat(shadowOf(service).isStoppedBySelf()).isTrue();
    assertThat(service.status()).isNull();
  }

  @Test
  public void aRobotStoppedDuringItsOpeningIsClosedAndMayStartAgain() throws Exception {
    startHeld(Robot::open);
    tell(RobotService.STOP);
    assertThat(service.phase()).isEqualTo(Phase.IDLE);
    assertThat(service.holdsLocks()).isTrue();
    goOn();
    assertThat(service.phase()).isEqualTo(Phase.IDLE);
    assertThat(service.status()).isNull();
    assertThat(service.holdsLocks()).isFalse();
    tell(RobotService.START);
    until(() -> service.phase() == Phase.RUNNING && car.turnsItsWheels());
  }

  @Test
  public void aFailedOpeningAfterAStopIsIgnored() throws Exception {
    startHeld((mission, links, files, log, onBug) -> {
      files.trace().close();
      throw new IOException("no such port");
    });
    tell(RobotService.STOP);
    goOn();
    assertThat(service.phase()).isEqualTo(Phase.IDLE);
    assertThat(service.problem()).isEmpty();
    assertThat(service.holdsLocks()).isFalse();
  }

  @Test
  public void aStopStopsTheWheelsFirstAndKeepsThePhoneAwakeUntilTheEnd() throws Exception {
    tell(RobotService.START);
    until(car::turnsItsWheels);
    RobotService.WORKER.execute(mayGoOn::acquireUninterruptibly);
    tell(RobotService.STOP);
    assertThat(isHeldBy(CreateHold.EMERGENCY_STOP)).isTrue();
    until(() -> !car.turnsItsWheels());
    assertThat(service.holdsLocks()).isTrue();
    assertThat(shadowOf(service).isForegroundStopped()).isFalse();
    goOn();
    assertThat(service.status()).isNull();
    assertThat(service.holdsLocks()).isFalse();
    assertThat(shadowOf(service).isForegroundStopped()).isTrue();
  }

  @Test
  public void aStartBeforeTheEndOfThePreviousRobotKeepsThePhoneAwake() throws Exception {
    tell(RobotService.START);
    until(() -> service.phase() == Phase.RUNNING && car.turnsItsWheels());
    RobotService.WORKER.execute(mayGoOn::acquireUninterruptibly);
    tell(RobotService.STOP);
    tell(RobotService.START);
    goOn();
    assertThat(service.phase()).isEqualTo(Phase.RUNNING);
    assertThat(service.holdsLocks()).isTrue();
    assertThat(shadowOf(service).isForegroundStopped()).isFalse();
    assertThat(shadowOf(service).isStoppedBySelf()).isFalse();
    until(car::turnsItsWheels);
    assertThat(isHeldBy(CreateHold.EMERGENCY_STOP)).isFalse();
  }

  @Test
  public void anEmergencyStopHoldsOverTheDeathOfTheServiceUntilItIsReleased()
      throws InterruptedException {
    tell(RobotService.START);
    until(car::turnsItsWheels);
    service.emergencyStop();
    until(() -> !car.turnsItsWheels());

    // Android kills the process without a call, and then starts the service without an intent.
    ServiceController<RobotService> killed = controller;
    controller = Robolectric.buildService(RobotService.class).create();
    RobotService next = controller.get();
    killed.destroy();
    service = next;
    service.onStartCommand(null, 0, 1);
    until(() -> service.phase() == Phase.RUNNING && isHeldBy(CreateHold.EMERGENCY_STOP));
    assertThat(service.isEmergency()).isTrue();
    until(() -> service.status().wheels().frames() > 50);
    assertThat(car.turnsItsWheels()).isFalse();

    service.release();
    until(car::turnsItsWheels);
    assertThat(new Store(application).isEmergency()).isFalse();
  }

  @Test
  public void aRobotIsOpenedAfterThatOfADestroyedServiceIsClosed() throws InterruptedException {
    tell(RobotService.START);
    until(car::turnsItsWheels);
    RobotService.WORKER.execute(mayGoOn::acquireUninterruptibly);
    RobotService dead = service;
    controller.destroy();
    controller = Robolectric.buildService(RobotService.class).create();
    service = controller.get();
    AtomicInteger opened = new AtomicInteger();
    service.opener =
        (mission, links, files, log, onBug) -> {
          opened.incrementAndGet();
          assertThat(dead.status()).isNull();
          return Robot.open(mission, links, files, log, onBug);
        };
    tell(RobotService.START);
    AtomicInteger ticks = new AtomicInteger();
    until(() -> opened.get() > 0 || ticks.incrementAndGet() > 100);
    mayGoOn.release();
    until(() -> service.phase() != Phase.STARTING);
    assertThat(service.phase()).as(service.problem()).isEqualTo(Phase.RUNNING);
    until(car::turnsItsWheels);
  }

  @Test
  public void withoutThePermissionNoRobotIsDriven() throws InterruptedException {
    shadowOf(application).denyPermissions(Manifest.permission.BLUETOOTH_CONNECT);
    tell(RobotService.START);
    assertThat(service.phase()).isEqualTo(Phase.FAILED);
    assertThat(service.problem()).contains(Manifest.permission.BLUETOOTH_CONNECT);
    assertThat(service.holdsLocks()).isFalse();
    until(() -> shadowOf(service).isForegroundStopped());
    assertThat(sockets).isEmpty();
  }

  @Test
  public void aRefusedForegroundServiceIsReportedAndNoRobotIsDriven() {
    shadowOf(service).setThrowInStartForeground(new IllegalStateException("not from there"));
    tell(RobotService.START);
    assertThat(service.phase()).isEqualTo(Phase.FAILED);
    assertThat(service.problem()).contains("start it here again");
    assertThat(service.holdsLocks()).isFalse();
    assertThat(sockets).isEmpty();
  }

  @Test
  public void aDeploymentUnfitForPhonesIsRefusedInOneLine()
      throws IOException, InterruptedException {
    load(deployment("crossroads"));
    tell(RobotService.START);
    until(() -> service.phase() == Phase.FAILED);
    assertThat(service.problem())
        .isEqualTo(
            "deployment.yaml:1: app: 'crossroads': expected one of [doors, hello, intersection,"
                + " lightpaint, maze, race, search], this phone's apps");
    until(() -> !service.holdsLocks());
  }

  @Test
  public void aRobotThatViolatesItsOwnLemmaStopsAndDrivesNoMore() throws Exception {
    load(deployment("doors"));
    tell(RobotService.START);
    until(car::turnsItsWheels);
    until(() -> service.phase() == Phase.FAILED);
    assertThat(service.problem())
        .contains("VIOLATED: Once violated at ", " s by bot0: is inside already");
    until(() -> !car.turnsItsWheels());
    service.release();
    AtomicInteger ticks = new AtomicInteger();
    until(() -> {
      assertThat(car.turnsItsWheels()).isFalse();
      return ticks.incrementAndGet() > 100;
    });
    tell(RobotService.STOP);
    until(() -> service.status() == null);
  }

  /** Places the car where the app's scenario has its only robot, and starts that app. */
  private void begin(Demo demo, String more) throws Exception {
    SortedMap<String, String> parameters = demo.defaults();
    Request request = new Request(7, OptionalInt.of(1), parameters);
    Plan plan = demo.plan(request, demo.defaultSettings(request).build());
    Pose start = plan.simulation().build().plan().robots().get(0).start();
    car.close();
    car = new SimulatedCar("bot0", start, clock, event -> {});
    load(deployment(demo.name()) + more + "seed: 7\n");
    tell(RobotService.START);
    until(() -> service.phase() != Phase.STARTING);
  }

  private void drives(Demo demo, String more) throws Exception {
    begin(demo, more);
    until(() -> {
      assertThat(service.problem()).isEmpty();
      return car.turnsItsWheels();
    });
    assertThat(service.status().app()).isEqualTo(demo.name());
    assertThat(service.status().appState()).startsWith("runs");
  }

  @Test
  public void theIntersectionDrives() throws Exception {
    drives(new IntersectionDemo(), "parameters: {scenario: figure7, debris: 0}\n");
  }

  @Test
  public void theRaceDrives() throws Exception {
    drives(new RaceDemo(), "");
  }

  @Test
  public void theMazeDrives() throws Exception {
    drives(new MazeDemo(), "");
  }

  @Test
  public void lightpaintDrives() throws Exception {
    drives(new LightPaintDemo(), "");
  }

  @Test
  public void theSearchDrivesWithAnObjectSensorOnly() throws Exception {
    begin(new SearchDemo(), "");
    until(() -> service.phase() == Phase.FAILED);
    assertThat(service.problem()).contains("this robot has no object sensor");
    assertThat(car.turnsItsWheels()).isFalse();
    tell(RobotService.STOP);
    until(() -> service.status() == null);
    drives(new SearchDemo(), "    objects: positions\n");
  }

  @Test
  public void theChosenAppRunsOnlyWhereTheDeploymentHasNone()
      throws IOException, InterruptedException {
    Store store = new Store(application);
    load(deployment("hello").replace("app: hello\n", ""));
    tell(RobotService.START);
    until(() -> service.phase() == Phase.FAILED);
    assertThat(service.problem())
        .isEqualTo(
            "this phone has no app yet: choose one of [doors, hello, intersection, lightpaint, maze,"
                + " race, search]");
    store.setApp("hello");
    tell(RobotService.START);
    until(() -> service.phase() == Phase.RUNNING);
    assertThat(service.status().app()).isEqualTo("hello");
    store.setApp("maze");
    load(deployment("hello"));
    assertThat(store.deployment().app()).isEqualTo("hello");
  }

  @Test
  public void theAppHandlesEmergencyStopAndLossOfTheLink()
      throws InterruptedException, IOException {
    refusals.set(1);
    tell(RobotService.START);
    until(car::turnsItsWheels);
    assertThat(services).contains(BluetoothLinks.SERIAL_PORT);

    service.emergencyStop();
    until(() -> !car.turnsItsWheels());
    assertThat(isHeldBy(CreateHold.EMERGENCY_STOP)).isTrue();
    service.release();
    until(car::turnsItsWheels);

    int before = sockets.size();
    sockets.get(before - 1).cut();
    until(() -> sockets.size() > before && car.turnsItsWheels());

    until(() -> service.status().appState().contains("ended"));
    assertThat(service.status().appState()).isEqualTo("has ended: [DONE]");
    assertThat(car.pose().xMm()).isBetween(900.0, 1100.0);
    assertThat(service.status().wheels().linksLost()).isEqualTo(1);
    tell(RobotService.STOP);
    until(() -> service.status() == null && !car.turnsItsWheels());
  }

  /** The process that guards the wheels is killed; its socket is closed for it. */
  private void killGuard() throws IOException {
    BinderShadow.die();
    sockets.get(sockets.size() - 1).cut();
  }

  @Test
  public void theWheelsStandUntilAnotherGuardIsThereIfTheirsIsKilled() throws Exception {
    tell(RobotService.START);
    until(car::turnsItsWheels);
    int before = sockets.size();
    killGuard();
    until(() -> !car.turnsItsWheels());
    // One link for the stop, and one for the next guard.
    until(() -> sockets.size() == before + 2 && car.turnsItsWheels());
    assertThat(sockets.get(before).isClosed()).isTrue();
  }

  @Test
  public void anEmergencyStopHoldsOverTheDeathOfTheGuard() throws Exception {
    tell(RobotService.START);
    until(car::turnsItsWheels);
    killGuard();
    service.emergencyStop();
    until(() -> !car.turnsItsWheels());
    long[] frames = {service.status().wheels().frames()};
    until(() -> {
      assertThat(frames[0] == 0 || !car.turnsItsWheels()).isTrue();
      return service.status().wheels().frames() > frames[0] + 50;
    });
    service.release();
    until(car::turnsItsWheels);
  }

  @Test
  public void aFrozenGuardIsKilledAndTheWheelsAreStoppedWithoutIt() throws Exception {
    tell(RobotService.START);
    until(car::turnsItsWheels);
    int before = sockets.size();
    BinderShadow.freeze();
    until(() -> sockets.size() > before);
    assertThat(ShadowProcess.wasKilled(Process.myPid())).isTrue();
    until(() -> sockets.size() == before + 2 && car.turnsItsWheels());
  }

  @Test
  public void theScreenNamesWhyTheGuardHasNoLink() throws Exception {
    refusals.set(Integer.MAX_VALUE);
    tell(RobotService.START);
    until(() -> service.status() != null && service.status().linkProblem() != null);
    assertThat(service.status().linkProblem())
        .hasMessage("read failed, socket might closed or timeout");
  }
}
