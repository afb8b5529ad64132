package org.starl.android.app;

import android.app.Notification;
import android.app.NotificationChannel;
import android.app.NotificationManager;
import android.app.PendingIntent;
import android.content.Context;
import android.content.Intent;

/** The notification while the phone drives a robot, with a button for the emergency stop. */
final class RobotNotification {

  static final int ID = 1;
  static final String CHANNEL = "robot";

  private final Context context;

  RobotNotification(Context context) {
    this.context = context;
    NotificationChannel channel =
        new NotificationChannel(
            CHANNEL, "Robot that is driven", NotificationManager.IMPORTANCE_LOW);
    context.getSystemService(NotificationManager.class).createNotificationChannel(channel);
  }

  Notification of(String line) {
    PendingIntent open =
        PendingIntent.getActivity(
            context, 0, new Intent(context, MainActivity.class), PendingIntent.FLAG_IMMUTABLE);
    return new Notification.Builder(context, CHANNEL)
        .setSmallIcon(android.R.drawable.ic_menu_compass)
        .setContentTitle("StarL robot")
        .setContentText(line)
        .setContentIntent(open)
        .setOngoing(true)
        .addAction(button("Emergency stop", RobotService.EMERGENCY_STOP))
        .addAction(button("End", RobotService.STOP))
        .build();
  }

  void show(String line) {
    context.getSystemService(NotificationManager.class).notify(ID, of(line));
  }

  private Notification.Action button(String words, String action) {
    Intent intent = new Intent(context, RobotService.class).setAction(action);
    PendingIntent pending =
        PendingIntent.getService(context, 0, intent, PendingIntent.FLAG_IMMUTABLE);
    return new Notification.Action.Builder(null, words, pending).build();
  }
}
