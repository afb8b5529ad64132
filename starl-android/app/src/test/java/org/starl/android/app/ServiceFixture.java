package org.starl.android.app;

import static org.robolectric.Shadows.shadowOf;

import android.Manifest;
import android.app.Application;
import android.bluetooth.BluetoothAdapter;
import android.bluetooth.BluetoothDevice;
import android.content.ComponentName;
import android.content.Intent;
import android.os.Looper;
import android.os.Process;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import org.junit.After;
import org.junit.Before;
import org.robolectric.Robolectric;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.android.controller.ServiceController;
import org.robolectric.shadows.ShadowProcess;
import org.starl.geometry.Pose;
import org.starl.robot.create.CreateHold;
import org.starl.robot.optitrack.NatNetServer;
import org.starl.robot.optitrack.PoseSource;
import org.starl.robot.realtime.RealClock;

/** A phone with one robot: its two services, a simulated Create behind the Bluetooth socket, cameras. */
abstract class ServiceFixture {

  static final long LIMIT_S = 60;

  final RealClock clock = new RealClock();
  SimulatedCar car = new SimulatedCar("bot0", new Pose(0, 0, 0), clock, event -> {});
  final List<SocketShadow> sockets = new CopyOnWriteArrayList<>();
  final List<UUID> services = new CopyOnWriteArrayList<>();
  final AtomicInteger refusals = new AtomicInteger();
  final Application application = RuntimeEnvironment.getApplication();

  /** Blocks the service's worker while a test holds it. */
  final Semaphore mayGoOn = new Semaphore(0);

  NatNetServer cameras;
  ServiceController<WheelsService> wheels;
  ServiceController<RobotService> controller;
  RobotService service;

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

  void connected(String address, SocketShadow socket) throws IOException {
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

  String deployment(String app) throws IOException {
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

  void load(String deployment) throws IOException {
    Store store = new Store(application);
    store.load(
        Store.Item.DEPLOYMENT,
        new ByteArrayInputStream(deployment.getBytes(StandardCharsets.UTF_8)));
    store.setRobotName("bot0");
  }

  void tell(String action) {
    service.onStartCommand(RobotService.intent(application, action), 0, 1);
  }

  void until(BooleanSupplier isSo) throws InterruptedException {
    car.until(() -> {
      shadowOf(Looper.getMainLooper()).idle();
      return isSo.getAsBoolean();
    });
  }

  /** Starts a robot whose opening blocks, and returns during the opening. */
  void startHeld(RobotService.Opener then) throws InterruptedException {
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
  void goOn() throws Exception {
    mayGoOn.release();
    RobotService.WORKER.submit(() -> {}).get(LIMIT_S, TimeUnit.SECONDS);
    shadowOf(Looper.getMainLooper()).idle();
  }

  boolean isHeldBy(CreateHold hold) {
    RobotStatus status = service.status();
    return status != null && status.wheels().holds().contains(hold);
  }
}
