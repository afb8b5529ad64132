/**
 * Makes the APK of the app for phones from compiled classes, without an Android SDK: {@code ./starl
 * apk}. aapt2 links manifest and resources, D8 makes dex of the classes that a phone takes and of the apps on the class path, apksig
 * signs by the schemes v2 and v3 and verifies what it signed.
 *
 * <p>Contract: the same classes, tools and key give the same APK, byte for byte, except a signature's
 * random part. A missing tool is reported in one line, with how to get it, and exit status 3; bad input
 * likewise, with status 2. A key is never written into the project.
 *
 * <p>An app gets in by its file {@code META-INF/services/org.starl.apps.AppFactory}, with all the
 * classes that it uses. One that uses the simulator, or what Android 8 lacks, is refused in one line.
 *
 * <p>Sources: "APK Signature Scheme v2" and "v3" of the Android Open Source Project, the
 * documentation of aapt2 and of D8.
 *
 * <p>May import: {@code org.starl.apps.AppFactory}, {@code org.starl.input}, apksig, R8, ASM,
 * animal-sniffer, picocli, the JDK.
 */
@NullMarked
package org.starl.android.apk;

import org.jspecify.annotations.NullMarked;
