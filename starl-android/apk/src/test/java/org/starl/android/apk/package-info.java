/**
 * What the APK holds, under test: the classes that D8 made dex of, translated back to class files. No
 * Android runtime takes part.
 */
package org.starl.android.apk;
