package org.starl.android.apk;

/**
 * The API levels of the APK.
 *
 * @param minSdk the oldest API level that it runs on: Android 8
 * @param targetSdk the API level whose rules it keeps: Android 16
 */
record Levels(int minSdk, int targetSdk, int versionCode, String versionName) {

  static final int MIN_SDK = 26;
  static final int TARGET_SDK = 36;

  /** The app's classes are compiled against Android 17's; its resources are older than that. */
  static final int COMPILE_SDK = 37;

  static final String COMPILE_VERSION = "17";
}
