package org.starl.android.app;

import android.app.Service;
import android.content.Context;
import android.content.Intent;
import android.content.pm.ServiceInfo;
import android.os.Binder;
import android.os.Build;
import android.os.Handler;
import android.os.IBinder;
import android.os.Looper;
import android.util.Log;
import java.io.IOException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.platform.LogSink;
import org.starl.robot.create.ByteLink;
import org.starl.robot.create.WheelGuard;

/**
 * Runs the robot as a foreground service, so that Android neither ends the process nor lets the phone
 * sleep. Intents control it; bound activities read its state.
 *
 * <p>Android may end it all the same and then starts it again: the robot's program starts as another
 * incarnation, and the wheels are stopped when the link to them is open again. An emergency stop holds
 * over that until it is released.
 *
 * <p>Each start and each end begins a new attempt. The late result of an older attempt, a robot or a
 * failure, is closed and ignored.
 */
public final class RobotService extends Service {

  /** Drives the robot that was loaded. */
  static final String START = "org.starl.android.app.START";

  /** Ends the robot and the service. */
  static final String STOP = "org.starl.android.app.STOP";

  static final String EMERGENCY_STOP = "org.starl.android.app.EMERGENCY_STOP";
  static final String RELEASE = "org.starl.android.app.RELEASE";

  private static final String TAG = "StarL";

  /** The service's state. */
  enum Phase {
    /** There is no robot. */
    IDLE,
    STARTING,
    RUNNING,
    /** The robot has failed or could not be opened: the problem has the reason. */
    FAILED
  }

  /** Gives clients in this process access to the service. */
  final class Access extends Binder {
    RobotService service() {
      return RobotService.this;
    }
  }

  /** Opens a robot, as {@link Robot#open} does; may block. */
  interface Opener {
    Robot open(
        Mission mission,
        ByteLink.Source links,
        Robot.Files files,
        LogSink log,
        Consumer<Throwable> onBug)
        throws IOException;
  }

  private final Access access = new Access();
  private final Handler main = new Handler(Looper.getMainLooper());

  /**
   * Opens and closes robots, in order. Of the process, so that the robot of a service that Android has
   * destroyed is closed, and its port is free, before the next service opens one.
   */
  static final ExecutorService WORKER =
      Executors.newSingleThreadExecutor(work -> new Thread(work, "robot service"));

  /** Set before the first start, if at all. */
  Opener opener = Robot::open;

  private @Nullable Locks locks;
  private @Nullable RobotNotification notification;
  private @Nullable NetworkWatch network;

  // Main thread only.
  private Phase phase = Phase.IDLE;
  private String problem = "";
  private int lastStartId;
  private int lightRgb = Robot.NO_LIGHT;
  private IntConsumer onLight = rgb -> {};

  // Counted by the main thread, which each time makes the worker close the earlier robot.
  private final AtomicInteger attempt = new AtomicInteger();

  // The worker sets this, then reads isEmergency and attempt; the main thread sets one of those,
  // then reads this. So at least one of the two threads stops the wheels.
  private volatile @Nullable Robot robot;
  private volatile boolean isEmergency;

  /** An intent for the service, from anywhere in this app. */
  static Intent intent(Context context, String action) {
    return new Intent(context, RobotService.class).setAction(action);
  }

  @Override
  public void onCreate() {
    super.onCreate();
    isEmergency = new Store(this).isEmergency();
    locks = new Locks(this);
    notification = new RobotNotification(this);
    network = new NetworkWatch(this);
    network.begin();
  }

  @Override
  public IBinder onBind(Intent intent) {
    return access;
  }

  @Override
  public int onStartCommand(@Nullable Intent intent, int flags, int startId) {
    lastStartId = startId;
    String action = intent == null ? START : String.valueOf(intent.getAction());
    switch (action) {
      case START -> begin();
      case STOP -> end();
      case EMERGENCY_STOP -> emergencyStop();
      case RELEASE -> release();
      default -> throw new IllegalArgumentException("unknown action " + action);
    }
    boolean isDriving = phase == Phase.STARTING || phase == Phase.RUNNING;
    return isDriving ? START_STICKY : START_NOT_STICKY;
  }

  @Override
  public void onDestroy() {
    if (network != null) {
      network.end();
    }
    attempt.incrementAndGet();
    stopWheels();
    WORKER.execute(() -> {
      closeRobot();
      main.post(this::releaseLocks);
    });
    super.onDestroy();
  }

  Phase phase() {
    RobotStatus status = status();
    return status != null && status.bug() != null ? Phase.FAILED : phase;
  }

  /** Why there is no running robot; empty if there is no problem. */
  String problem() {
    RobotStatus status = status();
    return status != null && status.bug() != null ? "cannot go on: " + status.bug() : problem;
  }

  /** The robot's state; null if there is none. */
  @Nullable RobotStatus status() {
    Robot here = robot;
    return here == null ? null : here.status();
  }

  NetworkWatch.State networkState() {
    return network == null ? NetworkWatch.State.NONE : network.state();
  }

  /** Sets the one receiver of the app's light, as {@link Robot#onLight}; on the main thread. */
  void onLight(IntConsumer receiver) {
    onLight = receiver;
    receiver.accept(lightRgb);
  }

  /** Shows the light of a robot; that of an earlier one is out. On the main thread. */
  void showLight(int ofAttempt, int rgb) {
    lightRgb = ofAttempt == attempt.get() ? rgb : Robot.NO_LIGHT;
    onLight.accept(lightRgb);
  }

  boolean isEmergency() {
    return isEmergency;
  }

  boolean holdsLocks() {
    return locks != null && locks.areHeld();
  }

  /** Stops the wheels at once, on the caller's thread; also those of a robot that is being opened. */
  void emergencyStop() {
    isEmergency = true;
    Robot here = robot;
    if (here != null) {
      here.emergencyStop();
      show("emergency stop");
    }
    storeEmergency();
  }

  private void storeEmergency() {
    if (!new Store(this).setEmergency(isEmergency)) {
      Log.e(TAG, "the emergency stop cannot be stored: it ends with this process");
    }
  }

  void release() {
    isEmergency = false;
    storeEmergency();
    Robot here = robot;
    if (here != null) {
      here.release();
      show(here.mission().robot().id() + " drives");
    }
  }

  private void begin() {
    if (phase() == Phase.STARTING || phase() == Phase.RUNNING) {
      return;
    }
    int mine = attempt.incrementAndGet();
    phase = Phase.STARTING;
    problem = "";
    try {
      goToForeground();
    } catch (IllegalStateException e) {
      // Since Android 12, when the system restarts a service in the background.
      giveUp("Android does not let it drive in the background: start it here again");
      return;
    }
    if (!Permissions.missing(this).isEmpty()) {
      giveUp("not allowed: " + Permissions.missing(this));
      return;
    }
    if (locks != null) {
      locks.acquire();
    }
    WORKER.execute(() -> open(mine));
  }

  /** Ends the robot, wheels first, and the service if no client is bound. */
  private void end() {
    attempt.incrementAndGet();
    stopWheels();
    phase = Phase.IDLE;
    leaveSoon();
  }

  private void stopWheels() {
    Robot here = robot;
    if (here != null) {
      here.emergencyStop();
    }
  }

  // On the worker.
  private void open(int mine) {
    closeRobot();
    if (attempt.get() != mine) {
      return;
    }
    try {
      Store store = new Store(this);
      Mission mission = store.mission();
      String name = mission.robot().id().name();
      Robot opened =
          opener.open(
              mission,
              links(mission),
              new Robot.Files(store.robotFolder(name), store.newTrace(name)),
              RobotService::log,
              bug -> robotFailed(mine, bug));
      robot = opened;
      opened.onLight(rgb -> main.post(() -> showLight(mine, rgb)));
      if (isEmergency || attempt.get() != mine) {
        opened.emergencyStop();
      }
      onMain(mine, () -> runs(mission));
    } catch (IOException | BadInput e) {
      onMain(mine, () -> giveUp(String.valueOf(e.getMessage())));
    }
  }

  /** Runs the action on the main thread, unless another attempt has begun by then. */
  private void onMain(int mine, Runnable work) {
    main.post(() -> {
      if (attempt.get() == mine) {
        work.run();
      }
    });
  }

  private void runs(Mission mission) {
    phase = Phase.RUNNING;
    show(mission.robot().id() + " runs " + mission.deployment().app());
  }

  private ByteLink.Source links(Mission mission) {
    long validMs = WheelGuard.validMs(mission.deployment().limits().reactionMs());
    return new GuardedLinks(getApplicationContext(), mission.port(), validMs);
  }

  // From any thread: its wheels are already stopped.
  private void robotFailed(int mine, Throwable bug) {
    Log.e(TAG, "the robot cannot go on", bug);
    onMain(
        mine,
        () -> {
          show("cannot go on: " + bug);
          showLight(mine, Robot.NO_LIGHT);
        });
  }

  // There will be no robot.
  private void giveUp(String why) {
    phase = Phase.FAILED;
    problem = why;
    leaveSoon();
  }

  private void goToForeground() {
    if (notification == null) {
      throw new IllegalStateException("a command before the service was made");
    }
    if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.Q) {
      startForeground(
          RobotNotification.ID,
          notification.of("starts"),
          ServiceInfo.FOREGROUND_SERVICE_TYPE_CONNECTED_DEVICE);
    } else {
      startForeground(RobotNotification.ID, notification.of("starts"));
    }
  }

  /** Leaves the foreground and releases the locks after the robot is closed and its wheels stand. */
  private void leaveSoon() {
    int mine = attempt.get();
    WORKER.execute(() -> {
      closeRobot();
      onMain(mine, this::leave);
    });
  }

  private void leave() {
    showLight(attempt.get(), Robot.NO_LIGHT);
    stopForeground(STOP_FOREGROUND_REMOVE);
    releaseLocks();
    // Has no effect if another command is on its way to this service.
    stopSelf(lastStartId);
  }

  private void releaseLocks() {
    if (locks != null) {
      locks.release();
    }
  }

  // On the worker.
  private void closeRobot() {
    Robot here = robot;
    if (here != null) {
      here.close();
      robot = null;
    }
  }

  private void show(String line) {
    if (notification != null) {
      notification.show(line);
    }
  }

  private static void log(long timeNs, LogSink.Level level, String tag, String line) {
    int priority =
        switch (level) {
          case DEBUG -> Log.DEBUG;
          case INFO -> Log.INFO;
          case WARN -> Log.WARN;
          case ERROR -> Log.ERROR;
        };
    Log.println(priority, TAG, tag + ": " + line);
  }
}
