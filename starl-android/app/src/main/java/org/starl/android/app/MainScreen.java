package org.starl.android.app;

import android.content.Context;
import android.graphics.Color;
import android.view.View;
import android.view.ViewGroup;
import android.widget.Button;
import android.widget.LinearLayout;
import android.widget.ScrollView;
import android.widget.TextView;
import java.util.List;
import org.starl.android.app.RobotService.Phase;

/** The activity's one screen: lines of text, buttons, and the emergency stop, which is always there. */
final class MainScreen {

  private static final int PADDING_DP = 12;
  private static final int TEXT_SP = 16;
  private static final int STOP_TEXT_SP = 32;
  private static final int STOP_HEIGHT_DP = 120;
  private static final int RED = Color.rgb(0xC6, 0x28, 0x28);

  private final Context context;
  private final LinearLayout root;
  private final ScrollView scroll;
  private final View light;
  private final TextView identity;
  private final TextView notice;
  private final TextView status;
  private final Button start;
  private final Button stop;
  private final Button release;
  private final Button emergencyStop;

  MainScreen(Context context, MainActivity.Orders orders) {
    this.context = context;
    identity = text();
    notice = text();
    status = text();
    start = button("Start", orders::start);
    stop = button("End", orders::stop);
    release = button("Release the emergency stop", orders::release);
    emergencyStop = button("EMERGENCY STOP", orders::emergencyStop);
    emergencyStop.setBackgroundColor(RED);
    emergencyStop.setTextColor(Color.WHITE);
    emergencyStop.setTextSize(STOP_TEXT_SP);
    LinearLayout column = column();
    column.addView(identity);
    column.addView(button("Load deployment", orders::loadDeployment));
    column.addView(button("Load key", orders::loadKey));
    column.addView(button("Choose robot", orders::choose));
    column.addView(button("Choose app", orders::chooseApp));
    column.addView(notice);
    column.addView(status);
    column.addView(start);
    column.addView(stop);
    column.addView(release);
    column.addView(button("Save traces", orders::saveTraces));
    scroll = new ScrollView(context);
    scroll.addView(column);
    light = new View(context);
    light.setVisibility(View.GONE);
    light.setKeepScreenOn(true);
    light.setOnClickListener(view -> showLines());
    root = column();
    LinearLayout.LayoutParams rest =
        new LinearLayout.LayoutParams(ViewGroup.LayoutParams.MATCH_PARENT, 0, 1);
    root.addView(scroll, rest);
    root.addView(light, rest);
    root.addView(
        emergencyStop,
        new LinearLayout.LayoutParams(ViewGroup.LayoutParams.MATCH_PARENT, pixels(STOP_HEIGHT_DP)));
    // Behind the system's bars, where newer versions of Android let apps draw, there is nothing to
    // see.
    root.setFitsSystemWindows(true);
    showButtons(Phase.IDLE, false);
  }

  View view() {
    return root;
  }

  void showIdentity(String line) {
    identity.setText(line);
  }

  /** A line about the user's last action. */
  void showNotice(String line) {
    notice.setText(line);
  }

  void showStatus(List<String> lines) {
    status.setText(String.join("\n", lines));
  }

  /**
   * Shows the app's light instead of lines and buttons, in the whole window but the emergency stop,
   * which is dark meanwhile; black while the light is off. A touch shows the lines again, until the
   * light changes.
   *
   * @param rgb 24 bits, or {@link Robot#NO_LIGHT}
   */
  void showLight(int rgb) {
    if (rgb == Robot.NO_LIGHT) {
      showLines();
      return;
    }
    int colour = Color.rgb(rgb >> 16 & 0xFF, rgb >> 8 & 0xFF, rgb & 0xFF);
    light.setBackgroundColor(colour);
    root.setBackgroundColor(colour);
    emergencyStop.setBackgroundColor(Color.BLACK);
    light.setVisibility(View.VISIBLE);
    scroll.setVisibility(View.GONE);
  }

  private void showLines() {
    light.setVisibility(View.GONE);
    scroll.setVisibility(View.VISIBLE);
    root.setBackgroundColor(Color.TRANSPARENT);
    emergencyStop.setBackgroundColor(RED);
  }

  /** Shows the buttons that apply now; the emergency stop always does. */
  void showButtons(Phase phase, boolean isEmergency) {
    boolean isDriving = phase == Phase.STARTING || phase == Phase.RUNNING;
    start.setEnabled(!isDriving);
    stop.setEnabled(phase != Phase.IDLE);
    release.setEnabled(isEmergency);
  }

  private LinearLayout column() {
    LinearLayout column = new LinearLayout(context);
    column.setOrientation(LinearLayout.VERTICAL);
    int padding = pixels(PADDING_DP);
    column.setPadding(padding, padding, padding, padding);
    return column;
  }

  private TextView text() {
    TextView text = new TextView(context);
    // The theme's secondary colour is not readable in the sun.
    text.setTextAppearance(android.R.style.TextAppearance_DeviceDefault);
    text.setTextSize(TEXT_SP);
    return text;
  }

  private Button button(String words, Runnable order) {
    Button button = new Button(context);
    button.setText(words);
    button.setOnClickListener(view -> order.run());
    return button;
  }

  private int pixels(int dp) {
    return Math.round(dp * context.getResources().getDisplayMetrics().density);
  }
}
