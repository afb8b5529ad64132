/**
 * Makes the APK of the app for phones from compiled classes, without an Android SDK: {@code ./starl
 * apk}. aapt2 links manifest and resources, D8 makes dex of the classes that a phone takes, apksig
 * signs by the schemes v2 and v3 and verifies what it signed.
 *
 * <p>Contract: the same classes, tools and key give the same APK, byte for byte, except a signature's
 * random part. A missing tool is reported in one line, with how to get it, and exit status 3; bad input
 * likewise, with status 2. A key is never written into the project.
 *
 * <p>Sources: "APK Signature Scheme v2" and "v3" of the Android Open Source Project, the
 * documentation of aapt2 and of D8.
 *
 * <p>May import: apksig, R8, picocli, the JDK.
 */
@NullMarked
package org.starl.android.apk;

import org.jspecify.annotations.NullMarked;
