package org.starl.android.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.robolectric.Shadows.shadowOf;

import android.Manifest;
import android.app.Notification;
import android.content.pm.ServiceInfo;
import android.os.Process;
import java.io.IOException;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.android.controller.ServiceController;
import org.robolectric.annotation.Config;
import org.robolectric.shadows.ShadowPowerManager;
import org.robolectric.shadows.ShadowProcess;
import org.starl.android.app.RobotService.Phase;
import org.starl.robot.create.CreateHold;

/** The service: what it asks of Android, and whole runs of a robot behind the Bluetooth socket. */
@RunWith(RobolectricTestRunner.class)
@Category(TakesLong.class)
@Config(
    sdk = 37,
    shadows = {AdapterShadow.class, SocketShadow.class, BinderShadow.class})
public final class RobotServiceTest extends ServiceFixture {

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
            "deployment.yaml:1: app: 'crossroads': expected one of [doors, fleet, hello, intersection,"
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

  @Test
  public void theChosenAppRunsOnlyWhereTheDeploymentHasNone()
      throws IOException, InterruptedException {
    Store store = new Store(application);
    load(deployment("hello").replace("app: hello\n", ""));
    tell(RobotService.START);
    until(() -> service.phase() == Phase.FAILED);
    assertThat(service.problem())
        .isEqualTo(
            "this phone has no app yet: choose one of [doors, fleet, hello, intersection, lightpaint, maze,"
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
