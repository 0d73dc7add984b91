"""The drone's 103 configuration keys: type, category, who may write them, default.

Defaults of limits, rates and codecs are Parrot's (ARDroneLib SDK 2.0.1, config_keys.h). Where the
real default belongs to one machine (serial number, calibration, build date) the value here is a
neutral one of ours. Values are written as on the wire, without the exponent form of floats.
"""

from __future__ import annotations

from enum import Enum
from typing import NamedTuple


class KeyType(Enum):
    """How a value is written."""

    INT = "int"
    BOOL = "boolean"
    FLOAT = "float"
    DOUBLE = "double"
    TEXT = "string"
    PAIR = "vector of 2"
    VECTOR = "vector of 3"
    MATRIX = "matrix of 3 x 3"


class Category(Enum):
    """Which of the stacked configurations a key lives in."""

    COMMON = "common"
    APPLICATION = "application"
    USER = "user"
    SESSION = "session"


class Access(Enum):
    """When a key may be written: never, without the three ids, only with them, either way."""

    NO = "no"
    DEFAULT = "default configuration"
    IDS = "with ids"
    BOTH = "both"


class ConfigKey(NamedTuple):
    """One key and its facts."""

    name: str
    type: KeyType
    category: Category
    access: Access
    default: str

    @property
    def needs_ids(self) -> bool:
        """Whether writing takes CONFIG_IDS with a session, user and application of one's own."""
        return self.access is Access.IDS

    @property
    def writable(self) -> bool:
        """Whether it can be written at all."""
        return self.access is not Access.NO


_INT, _BOOL, _FLOAT, _DOUBLE, _TEXT, _PAIR, _VECTOR, _MATRIX = KeyType
_COMMON, _APPLICATION, _USER, _SESSION = Category
_NO, _DEFAULT, _IDS, _BOTH = Access

CONFIG_KEYS: tuple[ConfigKey, ...] = (
    ConfigKey("general:num_version_config", _INT, _COMMON, _NO, "1"),
    ConfigKey("general:num_version_mb", _INT, _COMMON, _NO, "33"),
    ConfigKey("general:num_version_soft", _TEXT, _COMMON, _NO, "2.4.8"),
    ConfigKey("general:drone_serial", _TEXT, _COMMON, _NO, ""),
    ConfigKey("general:soft_build_date", _TEXT, _COMMON, _NO, "2013-01-01 00:00"),
    ConfigKey("general:motor1_soft", _TEXT, _COMMON, _NO, "0.0"),
    ConfigKey("general:motor1_hard", _TEXT, _COMMON, _NO, "0.0"),
    ConfigKey("general:motor1_supplier", _TEXT, _COMMON, _NO, "0.0"),
    ConfigKey("general:motor2_soft", _TEXT, _COMMON, _NO, "0.0"),
    ConfigKey("general:motor2_hard", _TEXT, _COMMON, _NO, "0.0"),
    ConfigKey("general:motor2_supplier", _TEXT, _COMMON, _NO, "0.0"),
    ConfigKey("general:motor3_soft", _TEXT, _COMMON, _NO, "0.0"),
    ConfigKey("general:motor3_hard", _TEXT, _COMMON, _NO, "0.0"),
    ConfigKey("general:motor3_supplier", _TEXT, _COMMON, _NO, "0.0"),
    ConfigKey("general:motor4_soft", _TEXT, _COMMON, _NO, "0.0"),
    ConfigKey("general:motor4_hard", _TEXT, _COMMON, _NO, "0.0"),
    ConfigKey("general:motor4_supplier", _TEXT, _COMMON, _NO, "0.0"),
    ConfigKey("general:ardrone_name", _TEXT, _COMMON, _DEFAULT, "My ARDrone"),
    ConfigKey("general:flying_time", _INT, _COMMON, _NO, "0"),
    ConfigKey("general:navdata_demo", _BOOL, _COMMON, _DEFAULT, "FALSE"),
    ConfigKey("general:navdata_options", _INT, _APPLICATION, _BOTH, "65537"),
    ConfigKey("general:com_watchdog", _INT, _COMMON, _DEFAULT, "2"),
    ConfigKey("general:video_enable", _BOOL, _COMMON, _DEFAULT, "TRUE"),
    ConfigKey("general:vision_enable", _BOOL, _COMMON, _DEFAULT, "TRUE"),
    ConfigKey("general:vbat_min", _INT, _COMMON, _NO, "9000"),
    ConfigKey("control:accs_offset", _VECTOR, _COMMON, _NO, "-2048 2048 2048"),
    ConfigKey("control:accs_gains", _MATRIX, _COMMON, _NO, "1 0 0 0 -1 0 0 0 -1"),
    ConfigKey("control:gyros_offset", _VECTOR, _COMMON, _NO, "1662.5 1662.5 1662.5"),
    ConfigKey("control:gyros_gains", _VECTOR, _COMMON, _NO, "0.001 -0.001 -0.001"),
    ConfigKey("control:gyros110_offset", _PAIR, _COMMON, _NO, "1662.5 1662.5"),
    ConfigKey("control:gyros110_gains", _PAIR, _COMMON, _NO, "0.0001 -0.0001"),
    ConfigKey("control:magneto_offset", _VECTOR, _COMMON, _NO, "0 0 0"),
    ConfigKey("control:magneto_radius", _FLOAT, _COMMON, _NO, "0"),
    ConfigKey("control:gyro_offset_thr_x", _FLOAT, _COMMON, _NO, "4"),
    ConfigKey("control:gyro_offset_thr_y", _FLOAT, _COMMON, _NO, "4"),
    ConfigKey("control:gyro_offset_thr_z", _FLOAT, _COMMON, _NO, "0.5"),
    ConfigKey("control:pwm_ref_gyros", _INT, _COMMON, _NO, "500"),
    ConfigKey("control:osctun_value", _INT, _COMMON, _NO, "63"),
    ConfigKey("control:osctun_test", _BOOL, _COMMON, _NO, "FALSE"),
    ConfigKey("control:control_level", _INT, _APPLICATION, _BOTH, "0"),
    ConfigKey("control:euler_angle_max", _FLOAT, _USER, _BOTH, "0.20943952"),
    ConfigKey("control:altitude_max", _INT, _COMMON, _DEFAULT, "3000"),
    ConfigKey("control:altitude_min", _INT, _COMMON, _DEFAULT, "50"),
    ConfigKey("control:control_iphone_tilt", _FLOAT, _USER, _BOTH, "0.34906584"),
    ConfigKey("control:control_vz_max", _FLOAT, _USER, _BOTH, "700"),
    ConfigKey("control:control_yaw", _FLOAT, _USER, _BOTH, "1.7453293"),
    ConfigKey("control:outdoor", _BOOL, _COMMON, _DEFAULT, "FALSE"),
    ConfigKey("control:flight_without_shell", _BOOL, _COMMON, _DEFAULT, "FALSE"),
    ConfigKey("control:autonomous_flight", _BOOL, _COMMON, _DEFAULT, "FALSE"),
    ConfigKey("control:manual_trim", _BOOL, _USER, _BOTH, "FALSE"),
    ConfigKey("control:indoor_euler_angle_max", _FLOAT, _USER, _BOTH, "0.20943952"),
    ConfigKey("control:indoor_control_vz_max", _FLOAT, _USER, _BOTH, "700"),
    ConfigKey("control:indoor_control_yaw", _FLOAT, _USER, _BOTH, "1.7453293"),
    ConfigKey("control:outdoor_euler_angle_max", _FLOAT, _USER, _BOTH, "0.34906584"),
    ConfigKey("control:outdoor_control_vz_max", _FLOAT, _USER, _BOTH, "1000"),
    ConfigKey("control:outdoor_control_yaw", _FLOAT, _USER, _BOTH, "3.4906585"),
    ConfigKey("control:flying_mode", _INT, _SESSION, _BOTH, "0"),
    ConfigKey("control:hovering_range", _INT, _SESSION, _BOTH, "1000"),
    ConfigKey("control:flight_anim", _TEXT, _COMMON, _DEFAULT, "0,0"),
    ConfigKey("network:ssid_single_player", _TEXT, _COMMON, _DEFAULT, "ardrone2"),
    ConfigKey("network:ssid_multi_player", _TEXT, _COMMON, _DEFAULT, "ardrone2"),
    ConfigKey("network:wifi_mode", _INT, _COMMON, _DEFAULT, "0"),
    ConfigKey("network:wifi_rate", _INT, _COMMON, _DEFAULT, "0"),
    ConfigKey("network:owner_mac", _TEXT, _COMMON, _DEFAULT, "00:00:00:00:00:00"),
    ConfigKey("pic:ultrasound_freq", _INT, _COMMON, _DEFAULT, "8"),
    ConfigKey("pic:ultrasound_watchdog", _INT, _COMMON, _DEFAULT, "3"),
    ConfigKey("pic:pic_version", _INT, _COMMON, _NO, "262192"),
    ConfigKey("video:camif_fps", _INT, _COMMON, _NO, "30"),
    ConfigKey("video:codec_fps", _INT, _SESSION, _IDS, "30"),
    ConfigKey("video:camif_buffers", _INT, _COMMON, _NO, "2"),
    ConfigKey("video:num_trackers", _INT, _COMMON, _NO, "12"),
    ConfigKey("video:video_codec", _INT, _SESSION, _IDS, "129"),
    ConfigKey("video:video_slices", _INT, _SESSION, _IDS, "0"),
    ConfigKey("video:video_live_socket", _INT, _SESSION, _IDS, "0"),
    ConfigKey("video:video_storage_space", _INT, _COMMON, _NO, "0"),
    ConfigKey("video:bitrate", _INT, _APPLICATION, _IDS, "1000"),
    ConfigKey("video:max_bitrate", _INT, _SESSION, _IDS, "1000"),
    ConfigKey("video:bitrate_ctrl_mode", _INT, _APPLICATION, _IDS, "0"),
    ConfigKey("video:bitrate_storage", _INT, _APPLICATION, _IDS, "4000"),
    ConfigKey("video:video_channel", _INT, _SESSION, _BOTH, "0"),
    ConfigKey("video:video_on_usb", _BOOL, _COMMON, _BOTH, "TRUE"),
    ConfigKey("video:video_file_index", _INT, _COMMON, _BOTH, "1"),
    ConfigKey("leds:leds_anim", _TEXT, _COMMON, _DEFAULT, "0,0,0"),
    ConfigKey("detect:enemy_colors", _INT, _COMMON, _DEFAULT, "1"),
    ConfigKey("detect:groundstripe_colors", _INT, _SESSION, _BOTH, "16"),
    ConfigKey("detect:enemy_without_shell", _INT, _COMMON, _DEFAULT, "0"),
    ConfigKey("detect:detect_type", _INT, _SESSION, _BOTH, "3"),
    ConfigKey("detect:detections_select_h", _INT, _SESSION, _BOTH, "0"),
    ConfigKey("detect:detections_select_v_hsync", _INT, _SESSION, _BOTH, "0"),
    ConfigKey("detect:detections_select_v", _INT, _SESSION, _BOTH, "0"),
    ConfigKey("syslog:output", _INT, _COMMON, _DEFAULT, "7"),
    ConfigKey("syslog:max_size", _INT, _COMMON, _DEFAULT, "102400"),
    ConfigKey("syslog:nb_files", _INT, _COMMON, _DEFAULT, "5"),
    ConfigKey("userbox:userbox_cmd", _TEXT, _SESSION, _BOTH, "0"),
    ConfigKey("gps:latitude", _DOUBLE, _SESSION, _BOTH, "500"),
    ConfigKey("gps:longitude", _DOUBLE, _SESSION, _BOTH, "500"),
    ConfigKey("gps:altitude", _DOUBLE, _SESSION, _BOTH, "0.0"),
    ConfigKey("custom:application_id", _TEXT, _SESSION, _BOTH, "00000000"),
    ConfigKey(
        "custom:application_desc", _TEXT, _APPLICATION, _BOTH, "Default application configuration"
    ),
    ConfigKey("custom:profile_id", _TEXT, _SESSION, _BOTH, "00000000"),
    ConfigKey("custom:profile_desc", _TEXT, _USER, _BOTH, ".Primary Profile"),
    ConfigKey("custom:session_id", _TEXT, _SESSION, _BOTH, "00000000"),
    ConfigKey("custom:session_desc", _TEXT, _SESSION, _BOTH, "Default session configuration"),
)
