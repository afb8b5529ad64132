package org.starl.android.app;

import android.Manifest;
import android.content.Context;
import android.content.pm.PackageManager;
import android.os.Build;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** The permissions that the user must grant, by Android's version; the manifest has the others. */
final class Permissions {

  /** Android 17's permission for access to the local network; the SDK used to compile lacks it. */
  static final String ACCESS_LOCAL_NETWORK = "android.permission.ACCESS_LOCAL_NETWORK";

  private static final int LOCAL_NETWORK_SINCE = 37;

  private Permissions() {}

  /** Without these no robot can be driven. */
  static List<String> required(int sdk, int targetSdk) {
    List<String> all = new ArrayList<>();
    if (sdk >= Build.VERSION_CODES.S) {
      all.add(Manifest.permission.BLUETOOTH_CONNECT);
    }
    if (sdk >= LOCAL_NETWORK_SINCE && targetSdk >= LOCAL_NETWORK_SINCE) {
      all.add(ACCESS_LOCAL_NETWORK);
    }
    return Collections.unmodifiableList(all);
  }

  /** All to ask for: {@link #required}, and to show the robot outside the activity. */
  static List<String> asked(int sdk, int targetSdk) {
    List<String> all = new ArrayList<>(required(sdk, targetSdk));
    if (sdk >= Build.VERSION_CODES.TIRAMISU) {
      all.add(Manifest.permission.POST_NOTIFICATIONS);
    }
    return Collections.unmodifiableList(all);
  }

  /** The required permissions that this phone has not granted. */
  static List<String> missing(Context context) {
    return notGranted(context, required(Build.VERSION.SDK_INT, targetSdk(context)));
  }

  /** The permissions that may be requested now. */
  static List<String> toAsk(Context context) {
    return notGranted(context, asked(Build.VERSION.SDK_INT, targetSdk(context)));
  }

  private static List<String> notGranted(Context context, List<String> permissions) {
    List<String> found = new ArrayList<>();
    for (String permission : permissions) {
      if (context.checkSelfPermission(permission) != PackageManager.PERMISSION_GRANTED) {
        found.add(permission);
      }
    }
    return found;
  }

  private static int targetSdk(Context context) {
    return context.getApplicationInfo().targetSdkVersion;
  }
}
