package org.starl.android.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.robolectric.Shadows.shadowOf;

import android.Manifest;
import android.app.Activity;
import android.app.Application;
import android.content.ComponentName;
import android.content.Intent;
import android.graphics.Color;
import android.graphics.drawable.ColorDrawable;
import android.net.Uri;
import android.os.Looper;
import android.view.View;
import android.view.ViewGroup;
import android.widget.Button;
import android.widget.TextView;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.zip.ZipInputStream;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.android.controller.ActivityController;
import org.robolectric.android.controller.ServiceController;
import org.robolectric.annotation.Config;
import org.robolectric.shadows.ShadowAlertDialog;

/** The one screen, bound to a service that has no robot. */
@RunWith(RobolectricTestRunner.class)
@Category(TakesLong.class)
@Config(sdk = 37)
public final class MainActivityTest {

  private static final long LIMIT_S = 60;

  private ServiceController<RobotService> service;
  private ActivityController<MainActivity> activity;

  @Before
  public void open() {
    var application = RuntimeEnvironment.getApplication();
    service = Robolectric.buildService(RobotService.class).create();
    shadowOf(application)
        .setComponentNameAndServiceForBindService(
            new ComponentName(application, RobotService.class), service.get().onBind(new Intent()));
    activity = Robolectric.buildActivity(MainActivity.class).setup();
    shadowOf(Looper.getMainLooper()).idleFor(Duration.ofSeconds(1));
  }

  @After
  public void close() {
    activity.pause().stop().destroy();
    service.destroy();
  }

  private List<TextView> texts() {
    List<TextView> found = new ArrayList<>();
    collect(activity.get().findViewById(android.R.id.content), found);
    return found;
  }

  private static void collect(View view, List<TextView> found) {
    if (view instanceof TextView text) {
      found.add(text);
    }
    if (view instanceof ViewGroup group) {
      for (int i = 0; i < group.getChildCount(); i++) {
        collect(group.getChildAt(i), found);
      }
    }
  }

  private String screen() {
    StringBuilder all = new StringBuilder();
    texts().forEach(text -> all.append(text.getText()).append('\n'));
    return all.toString();
  }

  /** The service's intents since the last call, without binding. */
  private List<String> orders() {
    List<String> found = new ArrayList<>();
    var shadow = shadowOf(activity.get());
    for (Intent next = shadow.getNextStartedService();
        next != null;
        next = shadow.getNextStartedService()) {
      if (next.getAction() != null) {
        found.add(next.getAction());
      }
    }
    return found;
  }

  private Button button(String words) {
    return texts().stream()
        .filter(text -> text instanceof Button && words.contentEquals(text.getText()))
        .map(Button.class::cast)
        .findFirst()
        .orElseThrow();
  }

  @Test
  public void theScreenShowsAvailableAndMissingParts() {
    assertThat(screen())
        .contains("no deployment: load one", "Robot: idle", "Network: ", "Phone's battery: ");
    assertThat(button("EMERGENCY STOP").isEnabled()).isTrue();
    assertThat(button("End").isEnabled()).isFalse();
  }

  @Test
  public void startAsksForMissingPermissionsAndStartsWhenGranted() {
    button("Start").performClick();
    assertThat(orders()).isEmpty();
    var asked = shadowOf(activity.get()).getLastRequestedPermission();
    assertThat(asked.requestedPermissions)
        .contains(Manifest.permission.BLUETOOTH_CONNECT, Manifest.permission.POST_NOTIFICATIONS);
    shadowOf(RuntimeEnvironment.getApplication()).grantPermissions(asked.requestedPermissions);
    activity.get().onRequestPermissionsResult(asked.requestCode, asked.requestedPermissions, null);
    assertThat(orders()).containsExactly(RobotService.START);
  }

  @Test
  public void theUserSeesTheAppsAndChoosesOne() throws Exception {
    Store store = new Store(RuntimeEnvironment.getApplication());
    String deployment =
        "positions: {source: natnet, server: 10.0.0.1}\n"
            + "network: {broadcasts: no}\n"
            + "robots: {bot0: {address: 10.0.0.2, chassis: {kind: create, port: 'tcp:10.0.0.3:23'}}}\n";
    store.load(
        Store.Item.DEPLOYMENT,
        new ByteArrayInputStream(deployment.getBytes(StandardCharsets.UTF_8)));
    button("Choose app").performClick();
    var dialog = shadowOf(ShadowAlertDialog.getLatestAlertDialog());
    assertThat(dialog.getItems()).contains("hello", "intersection", "race");
    dialog.clickOnItem(Arrays.asList(dialog.getItems()).indexOf("race"));
    assertThat(screen()).contains("1 robots, app race; choose the robot of this phone");
  }

  @Test
  public void aDeniedPermissionIsReportedAndNothingStarts() {
    button("Start").performClick();
    var asked = shadowOf(activity.get()).getLastRequestedPermission();
    activity.get().onRequestPermissionsResult(asked.requestCode, asked.requestedPermissions, null);
    assertThat(orders()).isEmpty();
    assertThat(screen()).contains("not allowed, so no robot is driven");
  }

  @Test
  public void anEmergencyStopBeforeTheServiceIsBoundIsKept() {
    activity.pause().stop();
    orders();
    button("EMERGENCY STOP").performClick();
    assertThat(orders()).containsExactly(RobotService.EMERGENCY_STOP);
    activity.start().resume();
  }

  @Test
  public void tracesAreSavedToTheChosenPlace() throws Exception {
    Application application = RuntimeEnvironment.getApplication();
    button("Save traces").performClick();
    assertThat(screen()).contains("choose a robot first");
    Store store = new Store(application);
    store.setRobotName("bot0");
    for (int start = 1; start <= 22; start++) {
      try (OutputStream trace = store.newTrace("bot0")) {
        trace.write(start);
      }
    }
    button("Save traces").performClick();
    var asked = shadowOf(activity.get()).getNextStartedActivityForResult();
    assertThat(asked.intent.getAction()).isEqualTo(Intent.ACTION_CREATE_DOCUMENT);
    assertThat(asked.intent.getStringExtra(Intent.EXTRA_TITLE)).isEqualTo("bot0-traces.zip");
    Uri chosen = Uri.parse("content://documents/traces");
    ByteArrayOutputStream saved = new ByteArrayOutputStream();
    shadowOf(application.getContentResolver()).registerOutputStream(chosen, saved);
    shadowOf(activity.get())
        .receiveResult(asked.intent, Activity.RESULT_OK, new Intent().setData(chosen));
    activity.get().saver.submit(() -> {}).get(LIMIT_S, TimeUnit.SECONDS);
    shadowOf(Looper.getMainLooper()).idle();
    assertThat(screen()).contains("saved 20 traces");
    try (ZipInputStream zip = new ZipInputStream(new ByteArrayInputStream(saved.toByteArray()))) {
      assertThat(zip.getNextEntry().getName()).isEqualTo("bot0.3.trace");
      assertThat(zip.readAllBytes()).containsExactly(3);
    }
  }

  @Test
  public void theEmergencyStopReachesTheServiceUntilItIsReleasedByHand() {
    button("EMERGENCY STOP").performClick();
    assertThat(service.get().isEmergency()).isTrue();
    shadowOf(Looper.getMainLooper()).idleFor(Duration.ofSeconds(1));
    button("Release the emergency stop").performClick();
    assertThat(service.get().isEmergency()).isFalse();
  }

  private boolean isShown(String words) {
    return texts().stream()
        .anyMatch(text -> text.getText().toString().contains(words) && text.isShown());
  }

  private int colour() {
    ViewGroup root =
        (ViewGroup) ((ViewGroup) activity.get().findViewById(android.R.id.content)).getChildAt(0);
    return ((ColorDrawable) root.getBackground()).getColor();
  }

  @Test
  public void theAppsLightFillsTheWindowButTheEmergencyStop() {
    service.get().showLight(0, 0xFF8800);
    assertThat(colour()).isEqualTo(Color.rgb(0xFF, 0x88, 0));
    assertThat(isShown("Load deployment")).isFalse();
    assertThat(isShown("EMERGENCY STOP")).isTrue();
    service.get().showLight(0, 0);
    assertThat(colour()).as("off").isEqualTo(Color.BLACK);
    service.get().showLight(0, Robot.NO_LIGHT);
    assertThat(isShown("Load deployment")).isTrue();
  }

  @Test
  public void theLightOfAnEarlierRobotIsOut() {
    service.get().showLight(0, 0xFF8800);
    service.get().showLight(-1, 0xFFFFFF);
    assertThat(isShown("Load deployment")).isTrue();
  }
}
