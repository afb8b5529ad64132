package org.starl.android.app;

import android.app.Activity;
import android.app.AlertDialog;
import android.content.ComponentName;
import android.content.Context;
import android.content.Intent;
import android.content.IntentFilter;
import android.content.ServiceConnection;
import android.net.Uri;
import android.os.BatteryManager;
import android.os.Bundle;
import android.os.Handler;
import android.os.IBinder;
import android.os.Looper;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.jspecify.annotations.Nullable;
import org.starl.android.app.Store.Item;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.robot.file.Deployment;

/** Shows the service's robot and passes the user's orders to it. */
public final class MainActivity extends Activity {

  private static final int ASK_PERMISSIONS = 1;
  private static final int LOAD_DEPLOYMENT = 2;
  private static final int LOAD_KEY = 3;
  private static final int SAVE_TRACES = 4;
  private static final long REFRESH_MS = 250;

  private final Handler handler = new Handler(Looper.getMainLooper());
  private final Runnable refresh = this::refresh;
  private final Connection connection = new Connection();

  /** Traces may be long, and the main thread must not wait. */
  final ExecutorService saver =
      Executors.newSingleThreadExecutor(work -> new Thread(work, "trace saver"));

  private @Nullable MainScreen screen;
  private @Nullable Store store;
  private @Nullable RobotService service;
  private boolean startsWhenAllowed;

  @Override
  protected void onCreate(@Nullable Bundle saved) {
    super.onCreate(saved);
    store = new Store(this);
    screen = new MainScreen(this, new Orders());
    setContentView(screen.view());
    showIdentity();
  }

  @Override
  protected void onStart() {
    super.onStart();
    bindService(new Intent(this, RobotService.class), connection, Context.BIND_AUTO_CREATE);
    handler.post(refresh);
  }

  @Override
  protected void onStop() {
    handler.removeCallbacks(refresh);
    if (service != null) {
      service.onLight(rgb -> {});
    }
    unbindService(connection);
    service = null;
    super.onStop();
  }

  @Override
  protected void onDestroy() {
    saver.shutdown();
    super.onDestroy();
  }

  @Override
  public void onRequestPermissionsResult(int request, String[] permissions, int[] results) {
    if (request == ASK_PERMISSIONS && startsWhenAllowed) {
      startsWhenAllowed = false;
      List<String> missing = Permissions.missing(this);
      if (missing.isEmpty()) {
        startRobot();
      } else {
        tell("not allowed, so no robot is driven: " + missing);
      }
    }
  }

  @Override
  protected void onActivityResult(int request, int result, @Nullable Intent data) {
    Uri file = data == null ? null : data.getData();
    if (result != RESULT_OK || file == null) {
      return;
    }
    if (request == SAVE_TRACES) {
      saver.execute(() -> save(file));
    } else {
      load(request == LOAD_KEY ? Item.KEY : Item.DEPLOYMENT, file);
    }
  }

  private void refresh() {
    RobotService here = service;
    if (screen != null && here != null) {
      screen.showStatus(
          StatusText.lines(
              here.phase(),
              here.problem(),
              here.status(),
              here.networkState(),
              phoneBatteryPercent()));
      screen.showButtons(here.phase(), here.isEmergency());
    }
    handler.postDelayed(refresh, REFRESH_MS);
  }

  private void showIdentity() {
    if (screen != null && store != null) {
      screen.showIdentity(StatusText.identity(deploymentOrNull(store), store.robotName()));
    }
  }

  private @Nullable Deployment deploymentOrNull(Store from) {
    try {
      return from.deployment();
    } catch (IOException | BadInput e) {
      tell(String.valueOf(e.getMessage()));
      return null;
    }
  }

  /** Charge of the phone's battery in percent; below 0 if unknown. */
  private int phoneBatteryPercent() {
    Intent battery = registerReceiver(null, new IntentFilter(Intent.ACTION_BATTERY_CHANGED));
    if (battery == null) {
      return -1;
    }
    int level = battery.getIntExtra(BatteryManager.EXTRA_LEVEL, -1);
    int scale = battery.getIntExtra(BatteryManager.EXTRA_SCALE, 0);
    return scale <= 0 ? -1 : 100 * level / scale;
  }

  private void load(Item item, Uri file) {
    try (InputStream from = getContentResolver().openInputStream(file)) {
      if (from != null && store != null) {
        store.load(item, from);
        tell("loaded");
        showIdentity();
      }
    } catch (IOException | BadInput e) {
      tell(String.valueOf(e.getMessage()));
    }
  }

  // On the saver's thread.
  private void save(Uri file) {
    String outcome;
    try (OutputStream to = getContentResolver().openOutputStream(file)) {
      if (to == null || store == null) {
        throw new IOException("nothing can be written there");
      }
      outcome = "saved " + store.saveTraces(store.robotName(), to) + " traces";
    } catch (IOException e) {
      outcome = "not saved: " + e.getMessage();
    }
    String line = outcome;
    handler.post(() -> tell(line));
  }

  private void chooseRobot() {
    Deployment deployment = store == null ? null : deploymentOrNull(store);
    if (deployment == null) {
      tell("load a deployment first");
      return;
    }
    String[] names =
        deployment.robots().keySet().stream().map(RobotId::name).toArray(String[]::new);
    new AlertDialog.Builder(this)
        .setTitle("This phone is")
        .setItems(
            names,
            (dialog, which) -> {
              if (store != null) {
                store.setRobotName(names[which]);
                showIdentity();
              }
            })
        .show();
  }

  /** Shows the apps of this phone; a deployment may leave the choice among them open. */
  private void chooseApp() {
    String[] names;
    try {
      names = PhoneApps.names().toArray(new String[0]);
    } catch (BadInput e) {
      tell(String.valueOf(e.getMessage()));
      return;
    }
    new AlertDialog.Builder(this)
        .setTitle("Apps on this phone")
        .setItems(
            names,
            (dialog, which) -> {
              if (store != null) {
                store.setApp(names[which]);
                showIdentity();
                tell(
                    "a deployment without an app runs "
                        + names[which]
                        + "; the others run their own");
              }
            })
        .show();
  }

  private void startRobot() {
    startForegroundService(RobotService.intent(this, RobotService.START));
  }

  private void tell(String line) {
    if (screen != null) {
      screen.showNotice(line);
    }
  }

  /** The actions of the screen's buttons. */
  final class Orders {

    void loadDeployment() {
      open(anyFile(), LOAD_DEPLOYMENT);
    }

    void loadKey() {
      open(anyFile(), LOAD_KEY);
    }

    void choose() {
      chooseRobot();
    }

    void chooseApp() {
      MainActivity.this.chooseApp();
    }

    void saveTraces() {
      String robot = store == null ? "" : store.robotName();
      if (robot.isEmpty()) {
        tell("choose a robot first");
        return;
      }
      open(
          new Intent(Intent.ACTION_CREATE_DOCUMENT)
              .setType("application/zip")
              .putExtra(Intent.EXTRA_TITLE, robot + "-traces.zip"),
          SAVE_TRACES);
    }

    void start() {
      tell("");
      List<String> toAsk = Permissions.toAsk(MainActivity.this);
      if (Permissions.missing(MainActivity.this).isEmpty()) {
        startRobot();
      } else {
        startsWhenAllowed = true;
      }
      if (!toAsk.isEmpty()) {
        requestPermissions(toAsk.toArray(new String[0]), ASK_PERMISSIONS);
      }
    }

    void stop() {
      startService(RobotService.intent(MainActivity.this, RobotService.STOP));
    }

    /** Stops the wheels at once; by an intent, which may wait, only before the service is bound. */
    void emergencyStop() {
      if (service != null) {
        service.emergencyStop();
      } else {
        startService(RobotService.intent(MainActivity.this, RobotService.EMERGENCY_STOP));
      }
    }

    void release() {
      if (service != null) {
        service.release();
      }
    }

    private Intent anyFile() {
      return new Intent(Intent.ACTION_OPEN_DOCUMENT).setType("*/*");
    }

    private void open(Intent intent, int request) {
      startActivityForResult(intent.addCategory(Intent.CATEGORY_OPENABLE), request);
    }
  }

  private final class Connection implements ServiceConnection {

    @Override
    public void onServiceConnected(ComponentName name, IBinder binder) {
      service = ((RobotService.Access) binder).service();
      service.onLight(rgb -> {
        if (screen != null) {
          screen.showLight(rgb);
        }
      });
    }

    @Override
    public void onServiceDisconnected(ComponentName name) {
      service = null;
    }
  }
}
