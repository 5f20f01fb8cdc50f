(()=>{var jm=0,Cf=1,Jm=2;var Er=1,Km=2,Ro=3,lr=0,ri=1,Ri=2,Ds=0,Po=1,Rf=2,Pf=3,If=4,Qm=5;var Ar=100,eg=101,tg=102,ng=103,ig=104,sg=200,rg=201,og=202,ag=203,Lf=204,Nf=205,lg=206,cg=207,ug=208,hg=209,fg=210,dg=211,pg=212,mg=213,gg=214,gc=0,_c=1,xc=2,xo=3,vc=4,yc=5,Sc=6,Mc=7,Zc=0,_g=1,xg=2,hs=0,Df=1,Uf=2,Ff=3,Of=4,Bf=5,kf=6,Ha=7;var zf=300,Tr=301,Io=302,jc=303,Jc=304,bc=1e3,cs=1001,wc=1002,kn=1003,vg=1004;var Wa=1005;var si=1006,Kc=1007;var Us=1008;var $n=1009,Gf=1010,Vf=1011,Lo=1012,Qc=1013,qi=1014,$i=1015,Yi=1016,eu=1017,tu=1018,Cr=1020,Hf=35902,Wf=35899,Xf=1021,qf=1022,ci=1023,Cs=1026,Fs=1027,Xa=1028,nu=1029,Zi=1030,iu=1031;var su=1033,qa=33776,$a=33777,Ya=33778,Za=33779,ru=35840,ou=35841,au=35842,lu=35843,cu=36196,uu=37492,hu=37496,fu=37488,du=37489,ja=37490,pu=37491,mu=37808,gu=37809,_u=37810,xu=37811,vu=37812,yu=37813,Su=37814,Mu=37815,bu=37816,wu=37817,Eu=37818,Au=37819,Tu=37820,Cu=37821,Ru=36492,Pu=36494,Iu=36495,Lu=36283,Nu=36284,Ja=36285,Du=36286;var Sa=2300,Ec=2301,pc=2302,yf=2303,Sf=2400,Mf=2401,bf=2402;var yg=3200;var Ka=0,Sg=1,Os="",ni="srgb",Ma="srgb-linear",ba="linear",Rt="srgb";var mc=7680;var Mg=519,bg=512,wg=513,Eg=514,$f=515,Ag=516,Tg=517,Yf=518,Zf=519,Cg=35044,Qa=35048;var jf="300 es",Ti=2e3,vo=2001;function xM(t){for(let e=t.length-1;e>=0;--e)if(t[e]>=65535)return!0;return!1}function vM(t){return ArrayBuffer.isView(t)&&!(t instanceof DataView)}function wa(t){return document.createElementNS("http://www.w3.org/1999/xhtml",t)}function Rg(){let t=wa("canvas");return t.style.display="block",t}var Sm={},yo=null;function Jf(...t){let e="THREE."+t.shift();yo?yo("log",e,...t):console.log(e,...t)}function Pg(t){let e=t[0];if(typeof e=="string"&&e.startsWith("TSL:")){let n=t[1];n&&n.isStackTrace?t[0]+=" "+n.getLocation():t[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return t}function Je(...t){t=Pg(t);let e="THREE."+t.shift();if(yo)yo("warn",e,...t);else{let n=t[0];n&&n.isStackTrace?console.warn(n.getError(e)):console.warn(e,...t)}}function tt(...t){t=Pg(t);let e="THREE."+t.shift();if(yo)yo("error",e,...t);else{let n=t[0];n&&n.isStackTrace?console.error(n.getError(e)):console.error(e,...t)}}function ya(...t){let e=t.join(" ");e in Sm||(Sm[e]=!0,Je(...t))}function Ig(t,e,n){return new Promise(function(i,s){function r(){switch(t.clientWaitSync(e,t.SYNC_FLUSH_COMMANDS_BIT,0)){case t.WAIT_FAILED:s();break;case t.TIMEOUT_EXPIRED:setTimeout(r,n);break;default:i()}}setTimeout(r,n)})}var Lg={[gc]:gc,[xc]:Sc,[vc]:vc,[xo]:yc,[_c]:_c,[Sc]:xc,[Mc]:Mc,[yc]:xo},Vi=class{addEventListener(e,n){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(n)===-1&&i[e].push(n)}hasEventListener(e,n){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(n)!==-1}removeEventListener(e,n){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(n);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let n=this._listeners;if(n===void 0)return;let i=n[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Xn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var jh=Math.PI/180,Ac=180/Math.PI;function el(){let t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Xn[t&255]+Xn[t>>8&255]+Xn[t>>16&255]+Xn[t>>24&255]+"-"+Xn[e&255]+Xn[e>>8&255]+"-"+Xn[e>>16&15|64]+Xn[e>>24&255]+"-"+Xn[n&63|128]+Xn[n>>8&255]+"-"+Xn[n>>16&255]+Xn[n>>24&255]+Xn[i&255]+Xn[i>>8&255]+Xn[i>>16&255]+Xn[i>>24&255]).toLowerCase()}function yt(t,e,n){return Math.max(e,Math.min(n,t))}function yM(t,e){return(t%e+e)%e}function Jh(t,e,n){return(1-n)*t+n*e}function Ng(t){return Math.pow(2,Math.floor(Math.log(t)/Math.LN2))}function Kf(t){switch(t.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function SM(t,e){if(e.constructor===Float32Array)return t;let n=Kf(e);if(n===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(t/n,-1)}function MM(t,e){if(e.constructor===Float32Array)return t;let n=Kf(e);if(n===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(t*n)}var it=class{static{this.prototype.isVector2=!0}constructor(e=0,n=0){this.x=e,this.y=n}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,n){return this.x=e,this.y=n,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,n){switch(e){case 0:this.x=n;break;case 1:this.y=n;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,n){return this.x=e.x+n.x,this.y=e.y+n.y,this}addScaledVector(e,n){return this.x+=e.x*n,this.y+=e.y*n,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,n){return this.x=e.x-n.x,this.y=e.y-n.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let n=this.x,i=this.y,s=e.elements;return this.x=s[0]*n+s[3]*i+s[6],this.y=s[1]*n+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,n){return this.x=yt(this.x,e.x,n.x),this.y=yt(this.y,e.y,n.y),this}clampScalar(e,n){return this.x=yt(this.x,e,n),this.y=yt(this.y,e,n),this}clampLength(e,n){let i=this.length();return this.divideScalar(i||1).multiplyScalar(yt(i,e,n))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let n=Math.sqrt(this.lengthSq()*e.lengthSq());if(n===0)return Math.PI/2;let i=this.dot(e)/n;return Math.acos(yt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let n=this.x-e.x,i=this.y-e.y;return n*n+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,n){return this.x+=(e.x-this.x)*n,this.y+=(e.y-this.y)*n,this}lerpVectors(e,n,i){return this.x=e.x+(n.x-e.x)*i,this.y=e.y+(n.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,n=0){return this.x=e[n],this.y=e[n+1],this}toArray(e=[],n=0){return e[n]=this.x,e[n+1]=this.y,e}fromBufferAttribute(e,n){return this.x=e.getX(n),this.y=e.getY(n),this}rotateAround(e,n){let i=Math.cos(n),s=Math.sin(n),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Tt=class{constructor(e=0,n=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=n,this._z=i,this._w=s}static slerpFlat(e,n,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],f=r[o+0],d=r[o+1],g=r[o+2],y=r[o+3];if(h!==y||l!==f||c!==d||u!==g){let p=l*f+c*d+u*g+h*y;p<0&&(f=-f,d=-d,g=-g,y=-y,p=-p);let m=1-a;if(p<.9995){let v=Math.acos(p),T=Math.sin(v);m=Math.sin(m*v)/T,a=Math.sin(a*v)/T,l=l*m+f*a,c=c*m+d*a,u=u*m+g*a,h=h*m+y*a}else{l=l*m+f*a,c=c*m+d*a,u=u*m+g*a,h=h*m+y*a;let v=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=v,c*=v,u*=v,h*=v}}e[n]=l,e[n+1]=c,e[n+2]=u,e[n+3]=h}static multiplyQuaternionsFlat(e,n,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],f=r[o+1],d=r[o+2],g=r[o+3];return e[n]=a*g+u*h+l*d-c*f,e[n+1]=l*g+u*f+c*h-a*d,e[n+2]=c*g+u*d+a*f-l*h,e[n+3]=u*g-a*h-l*f-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,n,i,s){return this._x=e,this._y=n,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,n=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),f=l(i/2),d=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h-f*d*g;break;case"YXZ":this._x=f*u*h+c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h+f*d*g;break;case"ZXY":this._x=f*u*h-c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h-f*d*g;break;case"ZYX":this._x=f*u*h-c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h+f*d*g;break;case"YZX":this._x=f*u*h+c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h-f*d*g;break;case"XZY":this._x=f*u*h-c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h+f*d*g;break;default:Je("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return n===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,n){let i=n/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let n=e.elements,i=n[0],s=n[4],r=n[8],o=n[1],a=n[5],l=n[9],c=n[2],u=n[6],h=n[10],f=i+a+h;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>h){let d=2*Math.sqrt(1+i-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>h){let d=2*Math.sqrt(1+a-i-h);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+h-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,n){let i=e.dot(n)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*n.z-e.z*n.y,this._y=e.z*n.x-e.x*n.z,this._z=e.x*n.y-e.y*n.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(yt(this.dot(e),-1,1)))}rotateTowards(e,n){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,n/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,n){let i=e._x,s=e._y,r=e._z,o=e._w,a=n._x,l=n._y,c=n._z,u=n._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,n){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-n;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,n=Math.sin(n*c)/u,this._x=this._x*l+i*n,this._y=this._y*l+s*n,this._z=this._z*l+r*n,this._w=this._w*l+o*n,this._onChangeCallback()}else this._x=this._x*l+i*n,this._y=this._y*l+s*n,this._z=this._z*l+r*n,this._w=this._w*l+o*n,this.normalize();return this}slerpQuaternions(e,n,i){return this.copy(e).slerp(n,i)}random(){let e=2*Math.PI*Math.random(),n=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(n),r*Math.cos(n))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,n=0){return this._x=e[n],this._y=e[n+1],this._z=e[n+2],this._w=e[n+3],this._onChangeCallback(),this}toArray(e=[],n=0){return e[n]=this._x,e[n+1]=this._y,e[n+2]=this._z,e[n+3]=this._w,e}fromBufferAttribute(e,n){return this._x=e.getX(n),this._y=e.getY(n),this._z=e.getZ(n),this._w=e.getW(n),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},F=class{static{this.prototype.isVector3=!0}constructor(e=0,n=0,i=0){this.x=e,this.y=n,this.z=i}set(e,n,i){return i===void 0&&(i=this.z),this.x=e,this.y=n,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,n){switch(e){case 0:this.x=n;break;case 1:this.y=n;break;case 2:this.z=n;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,n){return this.x=e.x+n.x,this.y=e.y+n.y,this.z=e.z+n.z,this}addScaledVector(e,n){return this.x+=e.x*n,this.y+=e.y*n,this.z+=e.z*n,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,n){return this.x=e.x-n.x,this.y=e.y-n.y,this.z=e.z-n.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,n){return this.x=e.x*n.x,this.y=e.y*n.y,this.z=e.z*n.z,this}applyEuler(e){return this.applyQuaternion(Mm.setFromEuler(e))}applyAxisAngle(e,n){return this.applyQuaternion(Mm.setFromAxisAngle(e,n))}applyMatrix3(e){let n=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*n+r[3]*i+r[6]*s,this.y=r[1]*n+r[4]*i+r[7]*s,this.z=r[2]*n+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let n=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*n+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*n+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*n+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*n+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let n=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*n-r*s),h=2*(r*i-o*n);return this.x=n+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let n=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*n+r[4]*i+r[8]*s,this.y=r[1]*n+r[5]*i+r[9]*s,this.z=r[2]*n+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,n){return this.x=yt(this.x,e.x,n.x),this.y=yt(this.y,e.y,n.y),this.z=yt(this.z,e.z,n.z),this}clampScalar(e,n){return this.x=yt(this.x,e,n),this.y=yt(this.y,e,n),this.z=yt(this.z,e,n),this}clampLength(e,n){let i=this.length();return this.divideScalar(i||1).multiplyScalar(yt(i,e,n))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,n){return this.x+=(e.x-this.x)*n,this.y+=(e.y-this.y)*n,this.z+=(e.z-this.z)*n,this}lerpVectors(e,n,i){return this.x=e.x+(n.x-e.x)*i,this.y=e.y+(n.y-e.y)*i,this.z=e.z+(n.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,n){let i=e.x,s=e.y,r=e.z,o=n.x,a=n.y,l=n.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let n=e.lengthSq();if(n===0)return this.set(0,0,0);let i=e.dot(this)/n;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Kh.copy(this).projectOnVector(e),this.sub(Kh)}reflect(e){return this.sub(Kh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let n=Math.sqrt(this.lengthSq()*e.lengthSq());if(n===0)return Math.PI/2;let i=this.dot(e)/n;return Math.acos(yt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let n=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return n*n+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,n,i){let s=Math.sin(n)*e;return this.x=s*Math.sin(i),this.y=Math.cos(n)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,n,i){return this.x=e*Math.sin(n),this.y=i,this.z=e*Math.cos(n),this}setFromMatrixPosition(e){let n=e.elements;return this.x=n[12],this.y=n[13],this.z=n[14],this}setFromMatrixScale(e){let n=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=n,this.y=i,this.z=s,this}setFromMatrixColumn(e,n){return this.fromArray(e.elements,n*4)}setFromMatrix3Column(e,n){return this.fromArray(e.elements,n*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,n=0){return this.x=e[n],this.y=e[n+1],this.z=e[n+2],this}toArray(e=[],n=0){return e[n]=this.x,e[n+1]=this.y,e[n+2]=this.z,e}fromBufferAttribute(e,n){return this.x=e.getX(n),this.y=e.getY(n),this.z=e.getZ(n),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,n=Math.random()*2-1,i=Math.sqrt(1-n*n);return this.x=i*Math.cos(e),this.y=n,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Kh=new F,Mm=new Tt,st=class{static{this.prototype.isMatrix3=!0}constructor(e,n,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,n,i,s,r,o,a,l,c)}set(e,n,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=n,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let n=this.elements,i=e.elements;return n[0]=i[0],n[1]=i[1],n[2]=i[2],n[3]=i[3],n[4]=i[4],n[5]=i[5],n[6]=i[6],n[7]=i[7],n[8]=i[8],this}extractBasis(e,n,i){return e.setFromMatrix3Column(this,0),n.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let n=e.elements;return this.set(n[0],n[4],n[8],n[1],n[5],n[9],n[2],n[6],n[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,n){let i=e.elements,s=n.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],f=i[2],d=i[5],g=i[8],y=s[0],p=s[3],m=s[6],v=s[1],T=s[4],S=s[7],C=s[2],A=s[5],_=s[8];return r[0]=o*y+a*v+l*C,r[3]=o*p+a*T+l*A,r[6]=o*m+a*S+l*_,r[1]=c*y+u*v+h*C,r[4]=c*p+u*T+h*A,r[7]=c*m+u*S+h*_,r[2]=f*y+d*v+g*C,r[5]=f*p+d*T+g*A,r[8]=f*m+d*S+g*_,this}multiplyScalar(e){let n=this.elements;return n[0]*=e,n[3]*=e,n[6]*=e,n[1]*=e,n[4]*=e,n[7]*=e,n[2]*=e,n[5]*=e,n[8]*=e,this}determinant(){let e=this.elements,n=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return n*o*u-n*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,n=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*r,d=c*r-o*l,g=n*h+i*f+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return e[0]=h*y,e[1]=(s*c-u*i)*y,e[2]=(a*i-s*o)*y,e[3]=f*y,e[4]=(u*n-s*l)*y,e[5]=(s*r-a*n)*y,e[6]=d*y,e[7]=(i*l-c*n)*y,e[8]=(o*n-i*r)*y,this}transpose(){let e,n=this.elements;return e=n[1],n[1]=n[3],n[3]=e,e=n[2],n[2]=n[6],n[6]=e,e=n[5],n[5]=n[7],n[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let n=this.elements;return e[0]=n[0],e[1]=n[3],e[2]=n[6],e[3]=n[1],e[4]=n[4],e[5]=n[7],e[6]=n[2],e[7]=n[5],e[8]=n[8],this}setUvTransform(e,n,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+n,0,0,1),this}scale(e,n){return ya("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Qh.makeScale(e,n)),this}rotate(e){return ya("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Qh.makeRotation(-e)),this}translate(e,n){return ya("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Qh.makeTranslation(e,n)),this}makeTranslation(e,n){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,n,0,0,1),this}makeRotation(e){let n=Math.cos(e),i=Math.sin(e);return this.set(n,-i,0,i,n,0,0,0,1),this}makeScale(e,n){return this.set(e,0,0,0,n,0,0,0,1),this}equals(e){let n=this.elements,i=e.elements;for(let s=0;s<9;s++)if(n[s]!==i[s])return!1;return!0}fromArray(e,n=0){for(let i=0;i<9;i++)this.elements[i]=e[i+n];return this}toArray(e=[],n=0){let i=this.elements;return e[n]=i[0],e[n+1]=i[1],e[n+2]=i[2],e[n+3]=i[3],e[n+4]=i[4],e[n+5]=i[5],e[n+6]=i[6],e[n+7]=i[7],e[n+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Qh=new st,bm=new st().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),wm=new st().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function bM(){let t={enabled:!0,workingColorSpace:Ma,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Rt&&(s.r=Ts(s.r),s.g=Ts(s.g),s.b=Ts(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Rt&&(s.r=_o(s.r),s.g=_o(s.g),s.b=_o(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Os?ba:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],n=[.2126,.7152,.0722],i=[.3127,.329];return t.define({[Ma]:{primaries:e,whitePoint:i,transfer:ba,toXYZ:bm,fromXYZ:wm,luminanceCoefficients:n,workingColorSpaceConfig:{unpackColorSpace:ni},outputColorSpaceConfig:{drawingBufferColorSpace:ni}},[ni]:{primaries:e,whitePoint:i,transfer:Rt,toXYZ:bm,fromXYZ:wm,luminanceCoefficients:n,outputColorSpaceConfig:{drawingBufferColorSpace:ni}}}),t}var xt=bM();function Ts(t){return t<.04045?t*.0773993808:Math.pow(t*.9478672986+.0521327014,2.4)}function _o(t){return t<.0031308?t*12.92:1.055*Math.pow(t,.41666)-.055}var io,Tc=class{static getDataURL(e,n="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{io===void 0&&(io=wa("canvas")),io.width=e.width,io.height=e.height;let s=io.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=io}return i.toDataURL(n)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let n=wa("canvas");n.width=e.width,n.height=e.height;let i=n.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ts(r[o]/255)*255;return i.putImageData(s,0,0),n}else if(e.data){let n=e.data.slice(0);for(let i=0;i<n.length;i++)n instanceof Uint8Array||n instanceof Uint8ClampedArray?n[i]=Math.floor(Ts(n[i]/255)*255):n[i]=Ts(n[i]);return{data:n,width:e.width,height:e.height}}else return Je("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},wM=0,So=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:wM++}),this.uuid=el(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let n=this.data;return typeof HTMLVideoElement<"u"&&n instanceof HTMLVideoElement?e.set(n.videoWidth,n.videoHeight,0):typeof VideoFrame<"u"&&n instanceof VideoFrame?e.set(n.displayWidth,n.displayHeight,0):n!==null?e.set(n.width||0,n.height||0,n.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let n=e===void 0||typeof e=="string";if(!n&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(ef(s[o].image)):r.push(ef(s[o]))}else r=ef(s);i.url=r}return n||(e.images[this.uuid]=i),i}};function ef(t){return typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap?Tc.getDataURL(t):t.data?{data:Array.from(t.data),width:t.width,height:t.height,type:t.data.constructor.name}:(Je("Texture: Unable to serialize Texture."),{})}var EM=0,tf=new F,li=class t extends Vi{constructor(e=t.DEFAULT_IMAGE,n=t.DEFAULT_MAPPING,i=cs,s=cs,r=si,o=Us,a=ci,l=$n,c=t.DEFAULT_ANISOTROPY,u=Os){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:EM++}),this.uuid=el(),this.name="",this.source=new So(e),this.mipmaps=[],this.mapping=n,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new it(0,0),this.repeat=new it(1,1),this.center=new it(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new st,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(tf).x}get height(){return this.source.getSize(tf).y}get depth(){return this.source.getSize(tf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,n){this.updateRanges.push({start:e,count:n})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let n in e){let i=e[n];if(i===void 0){Je(`Texture.setValues(): parameter '${n}' has value of undefined.`);continue}let s=this[n];if(s===void 0){Je(`Texture.setValues(): property '${n}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[n]=i}}toJSON(e){let n=e===void 0||typeof e=="string";if(!n&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),n||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==zf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case bc:e.x=e.x-Math.floor(e.x);break;case cs:e.x=e.x<0?0:1;break;case wc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case bc:e.y=e.y-Math.floor(e.y);break;case cs:e.y=e.y<0?0:1;break;case wc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};li.DEFAULT_IMAGE=null;li.DEFAULT_MAPPING=zf;li.DEFAULT_ANISOTROPY=1;var Ht=class{static{this.prototype.isVector4=!0}constructor(e=0,n=0,i=0,s=1){this.x=e,this.y=n,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,n,i,s){return this.x=e,this.y=n,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,n){switch(e){case 0:this.x=n;break;case 1:this.y=n;break;case 2:this.z=n;break;case 3:this.w=n;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,n){return this.x=e.x+n.x,this.y=e.y+n.y,this.z=e.z+n.z,this.w=e.w+n.w,this}addScaledVector(e,n){return this.x+=e.x*n,this.y+=e.y*n,this.z+=e.z*n,this.w+=e.w*n,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,n){return this.x=e.x-n.x,this.y=e.y-n.y,this.z=e.z-n.z,this.w=e.w-n.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let n=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*n+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*n+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*n+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*n+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let n=Math.sqrt(1-e.w*e.w);return n<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/n,this.y=e.y/n,this.z=e.z/n),this}setAxisAngleFromRotationMatrix(e){let n,i,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],g=l[9],y=l[2],p=l[6],m=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-y)<.01&&Math.abs(g-p)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+y)<.1&&Math.abs(g+p)<.1&&Math.abs(c+d+m-3)<.1)return this.set(1,0,0,0),this;n=Math.PI;let T=(c+1)/2,S=(d+1)/2,C=(m+1)/2,A=(u+f)/4,_=(h+y)/4,w=(g+p)/4;return T>S&&T>C?T<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(T),s=A/i,r=_/i):S>C?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=A/s,r=w/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=_/r,s=w/r),this.set(i,s,r,n),this}let v=Math.sqrt((p-g)*(p-g)+(h-y)*(h-y)+(f-u)*(f-u));return Math.abs(v)<.001&&(v=1),this.x=(p-g)/v,this.y=(h-y)/v,this.z=(f-u)/v,this.w=Math.acos((c+d+m-1)/2),this}setFromMatrixPosition(e){let n=e.elements;return this.x=n[12],this.y=n[13],this.z=n[14],this.w=n[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,n){return this.x=yt(this.x,e.x,n.x),this.y=yt(this.y,e.y,n.y),this.z=yt(this.z,e.z,n.z),this.w=yt(this.w,e.w,n.w),this}clampScalar(e,n){return this.x=yt(this.x,e,n),this.y=yt(this.y,e,n),this.z=yt(this.z,e,n),this.w=yt(this.w,e,n),this}clampLength(e,n){let i=this.length();return this.divideScalar(i||1).multiplyScalar(yt(i,e,n))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,n){return this.x+=(e.x-this.x)*n,this.y+=(e.y-this.y)*n,this.z+=(e.z-this.z)*n,this.w+=(e.w-this.w)*n,this}lerpVectors(e,n,i){return this.x=e.x+(n.x-e.x)*i,this.y=e.y+(n.y-e.y)*i,this.z=e.z+(n.z-e.z)*i,this.w=e.w+(n.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,n=0){return this.x=e[n],this.y=e[n+1],this.z=e[n+2],this.w=e[n+3],this}toArray(e=[],n=0){return e[n]=this.x,e[n+1]=this.y,e[n+2]=this.z,e[n+3]=this.w,e}fromBufferAttribute(e,n){return this.x=e.getX(n),this.y=e.getY(n),this.z=e.getZ(n),this.w=e.getW(n),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Cc=class extends Vi{constructor(e=1,n=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:si,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=n,this.depth=i.depth,this.scissor=new Ht(0,0,e,n),this.scissorTest=!1,this.viewport=new Ht(0,0,e,n),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new li({width:e,height:n,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let n={minFilter:si,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(n.mapping=e.mapping),e.wrapS!==void 0&&(n.wrapS=e.wrapS),e.wrapT!==void 0&&(n.wrapT=e.wrapT),e.wrapR!==void 0&&(n.wrapR=e.wrapR),e.magFilter!==void 0&&(n.magFilter=e.magFilter),e.minFilter!==void 0&&(n.minFilter=e.minFilter),e.format!==void 0&&(n.format=e.format),e.type!==void 0&&(n.type=e.type),e.anisotropy!==void 0&&(n.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(n.colorSpace=e.colorSpace),e.flipY!==void 0&&(n.flipY=e.flipY),e.generateMipmaps!==void 0&&(n.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(n.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(n.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(n)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,n,i=1){if(this.width!==e||this.height!==n||this.depth!==i){this.width=e,this.height=n,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=n,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,n),this.scissor.set(0,0,e,n)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let n=0,i=e.textures.length;n<i;n++){this.textures[n]=e.textures[n].clone(),this.textures[n].isRenderTargetTexture=!0,this.textures[n].renderTarget=this;let s=Object.assign({},e.textures[n].image);this.textures[n].source=new So(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let n=e.depthTexture.clone();n.renderTarget=null,this.depthTexture=n}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},gi=class extends Cc{constructor(e=1,n=1,i={}){super(e,n,i),this.isWebGLRenderTarget=!0}},Ea=class extends li{constructor(e=null,n=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:n,height:i,depth:s},this.magFilter=kn,this.minFilter=kn,this.wrapR=cs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Rc=class extends li{constructor(e=null,n=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:n,height:i,depth:s},this.magFilter=kn,this.minFilter=kn,this.wrapR=cs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Dt=class t{static{this.prototype.isMatrix4=!0}constructor(e,n,i,s,r,o,a,l,c,u,h,f,d,g,y,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,n,i,s,r,o,a,l,c,u,h,f,d,g,y,p)}set(e,n,i,s,r,o,a,l,c,u,h,f,d,g,y,p){let m=this.elements;return m[0]=e,m[4]=n,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=h,m[14]=f,m[3]=d,m[7]=g,m[11]=y,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new t().fromArray(this.elements)}copy(e){let n=this.elements,i=e.elements;return n[0]=i[0],n[1]=i[1],n[2]=i[2],n[3]=i[3],n[4]=i[4],n[5]=i[5],n[6]=i[6],n[7]=i[7],n[8]=i[8],n[9]=i[9],n[10]=i[10],n[11]=i[11],n[12]=i[12],n[13]=i[13],n[14]=i[14],n[15]=i[15],this}copyPosition(e){let n=this.elements,i=e.elements;return n[12]=i[12],n[13]=i[13],n[14]=i[14],this}setFromMatrix3(e){let n=e.elements;return this.set(n[0],n[3],n[6],0,n[1],n[4],n[7],0,n[2],n[5],n[8],0,0,0,0,1),this}extractBasis(e,n,i){return this.determinantAffine()===0?(e.set(1,0,0),n.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),n.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,n,i){return this.set(e.x,n.x,i.x,0,e.y,n.y,i.y,0,e.z,n.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let n=this.elements,i=e.elements,s=1/so.setFromMatrixColumn(e,0).length(),r=1/so.setFromMatrixColumn(e,1).length(),o=1/so.setFromMatrixColumn(e,2).length();return n[0]=i[0]*s,n[1]=i[1]*s,n[2]=i[2]*s,n[3]=0,n[4]=i[4]*r,n[5]=i[5]*r,n[6]=i[6]*r,n[7]=0,n[8]=i[8]*o,n[9]=i[9]*o,n[10]=i[10]*o,n[11]=0,n[12]=0,n[13]=0,n[14]=0,n[15]=1,this}makeRotationFromEuler(e){let n=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let f=o*u,d=o*h,g=a*u,y=a*h;n[0]=l*u,n[4]=-l*h,n[8]=c,n[1]=d+g*c,n[5]=f-y*c,n[9]=-a*l,n[2]=y-f*c,n[6]=g+d*c,n[10]=o*l}else if(e.order==="YXZ"){let f=l*u,d=l*h,g=c*u,y=c*h;n[0]=f+y*a,n[4]=g*a-d,n[8]=o*c,n[1]=o*h,n[5]=o*u,n[9]=-a,n[2]=d*a-g,n[6]=y+f*a,n[10]=o*l}else if(e.order==="ZXY"){let f=l*u,d=l*h,g=c*u,y=c*h;n[0]=f-y*a,n[4]=-o*h,n[8]=g+d*a,n[1]=d+g*a,n[5]=o*u,n[9]=y-f*a,n[2]=-o*c,n[6]=a,n[10]=o*l}else if(e.order==="ZYX"){let f=o*u,d=o*h,g=a*u,y=a*h;n[0]=l*u,n[4]=g*c-d,n[8]=f*c+y,n[1]=l*h,n[5]=y*c+f,n[9]=d*c-g,n[2]=-c,n[6]=a*l,n[10]=o*l}else if(e.order==="YZX"){let f=o*l,d=o*c,g=a*l,y=a*c;n[0]=l*u,n[4]=y-f*h,n[8]=g*h+d,n[1]=h,n[5]=o*u,n[9]=-a*u,n[2]=-c*u,n[6]=d*h+g,n[10]=f-y*h}else if(e.order==="XZY"){let f=o*l,d=o*c,g=a*l,y=a*c;n[0]=l*u,n[4]=-h,n[8]=c*u,n[1]=f*h+y,n[5]=o*u,n[9]=d*h-g,n[2]=g*h-d,n[6]=a*u,n[10]=y*h+f}return n[3]=0,n[7]=0,n[11]=0,n[12]=0,n[13]=0,n[14]=0,n[15]=1,this}makeRotationFromQuaternion(e){return this.compose(AM,e,TM)}lookAt(e,n,i){let s=this.elements;return pi.subVectors(e,n),pi.lengthSq()===0&&(pi.z=1),pi.normalize(),Zs.crossVectors(i,pi),Zs.lengthSq()===0&&(Math.abs(i.z)===1?pi.x+=1e-4:pi.z+=1e-4,pi.normalize(),Zs.crossVectors(i,pi)),Zs.normalize(),ql.crossVectors(pi,Zs),s[0]=Zs.x,s[4]=ql.x,s[8]=pi.x,s[1]=Zs.y,s[5]=ql.y,s[9]=pi.y,s[2]=Zs.z,s[6]=ql.z,s[10]=pi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,n){let i=e.elements,s=n.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],f=i[9],d=i[13],g=i[2],y=i[6],p=i[10],m=i[14],v=i[3],T=i[7],S=i[11],C=i[15],A=s[0],_=s[4],w=s[8],U=s[12],L=s[1],N=s[5],k=s[9],H=s[13],I=s[2],z=s[6],$=s[10],V=s[14],ae=s[3],q=s[7],K=s[11],ne=s[15];return r[0]=o*A+a*L+l*I+c*ae,r[4]=o*_+a*N+l*z+c*q,r[8]=o*w+a*k+l*$+c*K,r[12]=o*U+a*H+l*V+c*ne,r[1]=u*A+h*L+f*I+d*ae,r[5]=u*_+h*N+f*z+d*q,r[9]=u*w+h*k+f*$+d*K,r[13]=u*U+h*H+f*V+d*ne,r[2]=g*A+y*L+p*I+m*ae,r[6]=g*_+y*N+p*z+m*q,r[10]=g*w+y*k+p*$+m*K,r[14]=g*U+y*H+p*V+m*ne,r[3]=v*A+T*L+S*I+C*ae,r[7]=v*_+T*N+S*z+C*q,r[11]=v*w+T*k+S*$+C*K,r[15]=v*U+T*H+S*V+C*ne,this}multiplyScalar(e){let n=this.elements;return n[0]*=e,n[4]*=e,n[8]*=e,n[12]*=e,n[1]*=e,n[5]*=e,n[9]*=e,n[13]*=e,n[2]*=e,n[6]*=e,n[10]*=e,n[14]*=e,n[3]*=e,n[7]*=e,n[11]*=e,n[15]*=e,this}determinant(){let e=this.elements,n=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],d=e[14],g=e[3],y=e[7],p=e[11],m=e[15],v=l*d-c*f,T=a*d-c*h,S=a*f-l*h,C=o*d-c*u,A=o*f-l*u,_=o*h-a*u;return n*(y*v-p*T+m*S)-i*(g*v-p*C+m*A)+s*(g*T-y*C+m*_)-r*(g*S-y*A+p*_)}determinantAffine(){let e=this.elements,n=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return n*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,n;return n=e[1],e[1]=e[4],e[4]=n,n=e[2],e[2]=e[8],e[8]=n,n=e[6],e[6]=e[9],e[9]=n,n=e[3],e[3]=e[12],e[12]=n,n=e[7],e[7]=e[13],e[13]=n,n=e[11],e[11]=e[14],e[14]=n,this}setPosition(e,n,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=n,s[14]=i),this}invert(){let e=this.elements,n=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],d=e[11],g=e[12],y=e[13],p=e[14],m=e[15],v=n*a-i*o,T=n*l-s*o,S=n*c-r*o,C=i*l-s*a,A=i*c-r*a,_=s*c-r*l,w=u*y-h*g,U=u*p-f*g,L=u*m-d*g,N=h*p-f*y,k=h*m-d*y,H=f*m-d*p,I=v*H-T*k+S*N+C*L-A*U+_*w;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let z=1/I;return e[0]=(a*H-l*k+c*N)*z,e[1]=(s*k-i*H-r*N)*z,e[2]=(y*_-p*A+m*C)*z,e[3]=(f*A-h*_-d*C)*z,e[4]=(l*L-o*H-c*U)*z,e[5]=(n*H-s*L+r*U)*z,e[6]=(p*S-g*_-m*T)*z,e[7]=(u*_-f*S+d*T)*z,e[8]=(o*k-a*L+c*w)*z,e[9]=(i*L-n*k-r*w)*z,e[10]=(g*A-y*S+m*v)*z,e[11]=(h*S-u*A-d*v)*z,e[12]=(a*U-o*N-l*w)*z,e[13]=(n*N-i*U+s*w)*z,e[14]=(y*T-g*C-p*v)*z,e[15]=(u*C-h*T+f*v)*z,this}scale(e){let n=this.elements,i=e.x,s=e.y,r=e.z;return n[0]*=i,n[4]*=s,n[8]*=r,n[1]*=i,n[5]*=s,n[9]*=r,n[2]*=i,n[6]*=s,n[10]*=r,n[3]*=i,n[7]*=s,n[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,n=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(n,i,s))}makeTranslation(e,n,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,n,0,0,1,i,0,0,0,1),this}makeRotationX(e){let n=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,n,-i,0,0,i,n,0,0,0,0,1),this}makeRotationY(e){let n=Math.cos(e),i=Math.sin(e);return this.set(n,0,i,0,0,1,0,0,-i,0,n,0,0,0,0,1),this}makeRotationZ(e){let n=Math.cos(e),i=Math.sin(e);return this.set(n,-i,0,0,i,n,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,n){let i=Math.cos(n),s=Math.sin(n),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,n,i){return this.set(e,0,0,0,0,n,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,n,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,n,s,1,0,0,0,0,1),this}compose(e,n,i){let s=this.elements,r=n._x,o=n._y,a=n._z,l=n._w,c=r+r,u=o+o,h=a+a,f=r*c,d=r*u,g=r*h,y=o*u,p=o*h,m=a*h,v=l*c,T=l*u,S=l*h,C=i.x,A=i.y,_=i.z;return s[0]=(1-(y+m))*C,s[1]=(d+S)*C,s[2]=(g-T)*C,s[3]=0,s[4]=(d-S)*A,s[5]=(1-(f+m))*A,s[6]=(p+v)*A,s[7]=0,s[8]=(g+T)*_,s[9]=(p-v)*_,s[10]=(1-(f+y))*_,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,n,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),n.identity(),this;let o=so.set(s[0],s[1],s[2]).length(),a=so.set(s[4],s[5],s[6]).length(),l=so.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Bi.copy(this);let c=1/o,u=1/a,h=1/l;return Bi.elements[0]*=c,Bi.elements[1]*=c,Bi.elements[2]*=c,Bi.elements[4]*=u,Bi.elements[5]*=u,Bi.elements[6]*=u,Bi.elements[8]*=h,Bi.elements[9]*=h,Bi.elements[10]*=h,n.setFromRotationMatrix(Bi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,n,i,s,r,o,a=Ti,l=!1){let c=this.elements,u=2*r/(n-e),h=2*r/(i-s),f=(n+e)/(n-e),d=(i+s)/(i-s),g,y;if(l)g=r/(o-r),y=o*r/(o-r);else if(a===Ti)g=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===vo)g=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,n,i,s,r,o,a=Ti,l=!1){let c=this.elements,u=2/(n-e),h=2/(i-s),f=-(n+e)/(n-e),d=-(i+s)/(i-s),g,y;if(l)g=1/(o-r),y=o/(o-r);else if(a===Ti)g=-2/(o-r),y=-(o+r)/(o-r);else if(a===vo)g=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let n=this.elements,i=e.elements;for(let s=0;s<16;s++)if(n[s]!==i[s])return!1;return!0}fromArray(e,n=0){for(let i=0;i<16;i++)this.elements[i]=e[i+n];return this}toArray(e=[],n=0){let i=this.elements;return e[n]=i[0],e[n+1]=i[1],e[n+2]=i[2],e[n+3]=i[3],e[n+4]=i[4],e[n+5]=i[5],e[n+6]=i[6],e[n+7]=i[7],e[n+8]=i[8],e[n+9]=i[9],e[n+10]=i[10],e[n+11]=i[11],e[n+12]=i[12],e[n+13]=i[13],e[n+14]=i[14],e[n+15]=i[15],e}},so=new F,Bi=new Dt,AM=new F(0,0,0),TM=new F(1,1,1),Zs=new F,ql=new F,pi=new F,Em=new Dt,Am=new Tt,Ci=class t{constructor(e=0,n=0,i=0,s=t.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=n,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,n,i,s=this._order){return this._x=e,this._y=n,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,n=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],d=s[10];switch(n){case"XYZ":this._y=Math.asin(yt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-yt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(yt(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-yt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(yt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-yt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:Je("Euler: .setFromRotationMatrix() encountered an unknown order: "+n)}return this._order=n,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,n,i){return Em.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Em,n,i)}setFromVector3(e,n=this._order){return this.set(e.x,e.y,e.z,n)}reorder(e){return Am.setFromEuler(this),this.setFromQuaternion(Am,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],n=0){return e[n]=this._x,e[n+1]=this._y,e[n+2]=this._z,e[n+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ci.DEFAULT_ORDER="XYZ";var Mo=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},CM=0,Tm=new F,ro=new Tt,Ms=new Dt,$l=new F,ma=new F,RM=new F,PM=new Tt,Cm=new F(1,0,0),Rm=new F(0,1,0),Pm=new F(0,0,1),Im={type:"added"},IM={type:"removed"},oo={type:"childadded",child:null},nf={type:"childremoved",child:null},gn=class t extends Vi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:CM++}),this.uuid=el(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=t.DEFAULT_UP.clone();let e=new F,n=new Ci,i=new Tt,s=new F(1,1,1);function r(){i.setFromEuler(n,!1)}function o(){n.setFromQuaternion(i,void 0,!1)}n._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:n},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Dt},normalMatrix:{value:new st}}),this.matrix=new Dt,this.matrixWorld=new Dt,this.matrixAutoUpdate=t.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=t.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Mo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,n){this.quaternion.setFromAxisAngle(e,n)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,n){return ro.setFromAxisAngle(e,n),this.quaternion.multiply(ro),this}rotateOnWorldAxis(e,n){return ro.setFromAxisAngle(e,n),this.quaternion.premultiply(ro),this}rotateX(e){return this.rotateOnAxis(Cm,e)}rotateY(e){return this.rotateOnAxis(Rm,e)}rotateZ(e){return this.rotateOnAxis(Pm,e)}translateOnAxis(e,n){return Tm.copy(e).applyQuaternion(this.quaternion),this.position.add(Tm.multiplyScalar(n)),this}translateX(e){return this.translateOnAxis(Cm,e)}translateY(e){return this.translateOnAxis(Rm,e)}translateZ(e){return this.translateOnAxis(Pm,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ms.copy(this.matrixWorld).invert())}lookAt(e,n,i){e.isVector3?$l.copy(e):$l.set(e,n,i);let s=this.parent;this.updateWorldMatrix(!0,!1),ma.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ms.lookAt(ma,$l,this.up):Ms.lookAt($l,ma,this.up),this.quaternion.setFromRotationMatrix(Ms),s&&(Ms.extractRotation(s.matrixWorld),ro.setFromRotationMatrix(Ms),this.quaternion.premultiply(ro.invert()))}add(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.add(arguments[n]);return this}return e===this?(tt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Im),oo.child=e,this.dispatchEvent(oo),oo.child=null):tt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let n=this.children.indexOf(e);return n!==-1&&(e.parent=null,this.children.splice(n,1),e.dispatchEvent(IM),nf.child=e,this.dispatchEvent(nf),nf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ms.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ms.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ms),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Im),oo.child=e,this.dispatchEvent(oo),oo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,n){if(this[e]===n)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,n);if(o!==void 0)return o}}getObjectsByProperty(e,n,i=[]){this[e]===n&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,n,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ma,e,RM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ma,PM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let n=this.matrixWorld.elements;return e.set(n[8],n[9],n[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let n=this.children;for(let i=0,s=n.length;i<s;i++)n[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let n=this.children;for(let i=0,s=n.length;i<s;i++)n[i].traverseVisible(e)}traverseAncestors(e){let n=this.parent;n!==null&&(e(n),n.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let n=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=n-r[0]*n-r[4]*i-r[8]*s,r[13]+=i-r[1]*n-r[5]*i-r[9]*s,r[14]+=s-r[2]*n-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let n=this.children;for(let i=0,s=n.length;i<s;i++)n[i].updateMatrixWorld(e)}updateWorldMatrix(e,n,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),n===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let n=e===void 0||typeof e=="string",i={};n&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(n){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),d=o(e.animations),g=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),d.length>0&&(i.animations=d),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,n=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),n===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};gn.DEFAULT_UP=new F(0,1,0);gn.DEFAULT_MATRIX_AUTO_UPDATE=!0;gn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var un=class extends gn{constructor(){super(),this.isGroup=!0,this.type="Group"}},LM={type:"move"},bo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new un,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new un,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new F,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new F),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new un,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new F,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new F,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let n=this._hand;if(n)for(let i of e.hand.values())this._getHandJoint(n,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,n,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&n.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let p=n.getJointPose(y,i),m=this._getHandJoint(c,y);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,g=.005;c.inputState.pinching&&f>d+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=d-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=n.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=n.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(LM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,n){if(e.joints[n.jointName]===void 0){let i=new un;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[n.jointName]=i,e.add(i)}return e.joints[n.jointName]}},Dg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},js={h:0,s:0,l:0},Yl={h:0,s:0,l:0};function sf(t,e,n){return n<0&&(n+=1),n>1&&(n-=1),n<1/6?t+(e-t)*6*n:n<1/2?e:n<2/3?t+(e-t)*6*(2/3-n):t}var $e=class{constructor(e,n,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,n,i)}set(e,n,i){if(n===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,n,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,n=ni){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,xt.colorSpaceToWorking(this,n),this}setRGB(e,n,i,s=xt.workingColorSpace){return this.r=e,this.g=n,this.b=i,xt.colorSpaceToWorking(this,s),this}setHSL(e,n,i,s=xt.workingColorSpace){if(e=yM(e,1),n=yt(n,0,1),i=yt(i,0,1),n===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+n):i+n-i*n,o=2*i-r;this.r=sf(o,r,e+1/3),this.g=sf(o,r,e),this.b=sf(o,r,e-1/3)}return xt.colorSpaceToWorking(this,s),this}setStyle(e,n=ni){function i(r){r!==void 0&&parseFloat(r)<1&&Je("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,n);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,n);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,n);break;default:Je("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,n);if(o===6)return this.setHex(parseInt(r,16),n);Je("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,n);return this}setColorName(e,n=ni){let i=Dg[e.toLowerCase()];return i!==void 0?this.setHex(i,n):Je("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Ts(e.r),this.g=Ts(e.g),this.b=Ts(e.b),this}copyLinearToSRGB(e){return this.r=_o(e.r),this.g=_o(e.g),this.b=_o(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=ni){return xt.workingToColorSpace(qn.copy(this),e),Math.round(yt(qn.r*255,0,255))*65536+Math.round(yt(qn.g*255,0,255))*256+Math.round(yt(qn.b*255,0,255))}getHexString(e=ni){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,n=xt.workingColorSpace){xt.workingToColorSpace(qn.copy(this),n);let i=qn.r,s=qn.g,r=qn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,n=xt.workingColorSpace){return xt.workingToColorSpace(qn.copy(this),n),e.r=qn.r,e.g=qn.g,e.b=qn.b,e}getStyle(e=ni){xt.workingToColorSpace(qn.copy(this),e);let n=qn.r,i=qn.g,s=qn.b;return e!==ni?`color(${e} ${n.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(n*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,n,i){return this.getHSL(js),this.setHSL(js.h+e,js.s+n,js.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,n){return this.r=e.r+n.r,this.g=e.g+n.g,this.b=e.b+n.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,n){return this.r+=(e.r-this.r)*n,this.g+=(e.g-this.g)*n,this.b+=(e.b-this.b)*n,this}lerpColors(e,n,i){return this.r=e.r+(n.r-e.r)*i,this.g=e.g+(n.g-e.g)*i,this.b=e.b+(n.b-e.b)*i,this}lerpHSL(e,n){this.getHSL(js),e.getHSL(Yl);let i=Jh(js.h,Yl.h,n),s=Jh(js.s,Yl.s,n),r=Jh(js.l,Yl.l,n);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let n=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*n+r[3]*i+r[6]*s,this.g=r[1]*n+r[4]*i+r[7]*s,this.b=r[2]*n+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,n=0){return this.r=e[n],this.g=e[n+1],this.b=e[n+2],this}toArray(e=[],n=0){return e[n]=this.r,e[n+1]=this.g,e[n+2]=this.b,e}fromBufferAttribute(e,n){return this.r=e.getX(n),this.g=e.getY(n),this.b=e.getZ(n),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},qn=new $e;$e.NAMES=Dg;var Aa=class extends gn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ci,this.environmentIntensity=1,this.environmentRotation=new Ci,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,n){return super.copy(e,n),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let n=super.toJSON(e);return this.fog!==null&&(n.object.fog=this.fog.toJSON()),n.object.backgroundBlurriness=this.backgroundBlurriness,n.object.backgroundIntensity=this.backgroundIntensity,n.object.backgroundRotation=this.backgroundRotation.toArray(),n.object.environmentIntensity=this.environmentIntensity,n.object.environmentRotation=this.environmentRotation.toArray(),n}},ki=new F,bs=new F,rf=new F,ws=new F,ao=new F,lo=new F,Lm=new F,of=new F,af=new F,lf=new F,cf=new Ht,uf=new Ht,hf=new Ht,er=class t{constructor(e=new F,n=new F,i=new F){this.a=e,this.b=n,this.c=i}static getNormal(e,n,i,s){s.subVectors(i,n),ki.subVectors(e,n),s.cross(ki);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,n,i,s,r){ki.subVectors(s,n),bs.subVectors(i,n),rf.subVectors(e,n);let o=ki.dot(ki),a=ki.dot(bs),l=ki.dot(rf),c=bs.dot(bs),u=bs.dot(rf),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,d=(c*l-a*u)*f,g=(o*u-a*l)*f;return r.set(1-d-g,g,d)}static containsPoint(e,n,i,s){return this.getBarycoord(e,n,i,s,ws)===null?!1:ws.x>=0&&ws.y>=0&&ws.x+ws.y<=1}static getInterpolation(e,n,i,s,r,o,a,l){return this.getBarycoord(e,n,i,s,ws)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ws.x),l.addScaledVector(o,ws.y),l.addScaledVector(a,ws.z),l)}static getInterpolatedAttribute(e,n,i,s,r,o){return cf.setScalar(0),uf.setScalar(0),hf.setScalar(0),cf.fromBufferAttribute(e,n),uf.fromBufferAttribute(e,i),hf.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(cf,r.x),o.addScaledVector(uf,r.y),o.addScaledVector(hf,r.z),o}static isFrontFacing(e,n,i,s){return ki.subVectors(i,n),bs.subVectors(e,n),ki.cross(bs).dot(s)<0}set(e,n,i){return this.a.copy(e),this.b.copy(n),this.c.copy(i),this}setFromPointsAndIndices(e,n,i,s){return this.a.copy(e[n]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,n,i,s){return this.a.fromBufferAttribute(e,n),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return ki.subVectors(this.c,this.b),bs.subVectors(this.a,this.b),ki.cross(bs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return t.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,n){return t.getBarycoord(e,this.a,this.b,this.c,n)}getInterpolation(e,n,i,s,r){return t.getInterpolation(e,this.a,this.b,this.c,n,i,s,r)}containsPoint(e){return t.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return t.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,n){let i=this.a,s=this.b,r=this.c,o,a;ao.subVectors(s,i),lo.subVectors(r,i),of.subVectors(e,i);let l=ao.dot(of),c=lo.dot(of);if(l<=0&&c<=0)return n.copy(i);af.subVectors(e,s);let u=ao.dot(af),h=lo.dot(af);if(u>=0&&h<=u)return n.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),n.copy(i).addScaledVector(ao,o);lf.subVectors(e,r);let d=ao.dot(lf),g=lo.dot(lf);if(g>=0&&d<=g)return n.copy(r);let y=d*c-l*g;if(y<=0&&c>=0&&g<=0)return a=c/(c-g),n.copy(i).addScaledVector(lo,a);let p=u*g-d*h;if(p<=0&&h-u>=0&&d-g>=0)return Lm.subVectors(r,s),a=(h-u)/(h-u+(d-g)),n.copy(s).addScaledVector(Lm,a);let m=1/(p+y+f);return o=y*m,a=f*m,n.copy(i).addScaledVector(ao,o).addScaledVector(lo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},tr=class{constructor(e=new F(1/0,1/0,1/0),n=new F(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=n}set(e,n){return this.min.copy(e),this.max.copy(n),this}setFromArray(e){this.makeEmpty();for(let n=0,i=e.length;n<i;n+=3)this.expandByPoint(zi.fromArray(e,n));return this}setFromBufferAttribute(e){this.makeEmpty();for(let n=0,i=e.count;n<i;n++)this.expandByPoint(zi.fromBufferAttribute(e,n));return this}setFromPoints(e){this.makeEmpty();for(let n=0,i=e.length;n<i;n++)this.expandByPoint(e[n]);return this}setFromCenterAndSize(e,n){let i=zi.copy(n).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,n=!1){return this.makeEmpty(),this.expandByObject(e,n)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,n=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(n===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,zi):zi.fromBufferAttribute(r,o),zi.applyMatrix4(e.matrixWorld),this.expandByPoint(zi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Zl.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Zl.copy(i.boundingBox)),Zl.applyMatrix4(e.matrixWorld),this.union(Zl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],n);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,n){return n.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,zi),zi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let n,i;return e.normal.x>0?(n=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(n=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(n+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(n+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(n+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(n+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),n<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ga),jl.subVectors(this.max,ga),co.subVectors(e.a,ga),uo.subVectors(e.b,ga),ho.subVectors(e.c,ga),Js.subVectors(uo,co),Ks.subVectors(ho,uo),Sr.subVectors(co,ho);let n=[0,-Js.z,Js.y,0,-Ks.z,Ks.y,0,-Sr.z,Sr.y,Js.z,0,-Js.x,Ks.z,0,-Ks.x,Sr.z,0,-Sr.x,-Js.y,Js.x,0,-Ks.y,Ks.x,0,-Sr.y,Sr.x,0];return!ff(n,co,uo,ho,jl)||(n=[1,0,0,0,1,0,0,0,1],!ff(n,co,uo,ho,jl))?!1:(Jl.crossVectors(Js,Ks),n=[Jl.x,Jl.y,Jl.z],ff(n,co,uo,ho,jl))}clampPoint(e,n){return n.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,zi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(zi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Es[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Es[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Es[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Es[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Es[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Es[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Es[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Es[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Es),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Es=[new F,new F,new F,new F,new F,new F,new F,new F],zi=new F,Zl=new tr,co=new F,uo=new F,ho=new F,Js=new F,Ks=new F,Sr=new F,ga=new F,jl=new F,Jl=new F,Mr=new F;function ff(t,e,n,i,s){for(let r=0,o=t.length-3;r<=o;r+=3){Mr.fromArray(t,r);let a=s.x*Math.abs(Mr.x)+s.y*Math.abs(Mr.y)+s.z*Math.abs(Mr.z),l=e.dot(Mr),c=n.dot(Mr),u=i.dot(Mr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var bn=new F,Kl=new it,NM=0,en=class extends Vi{constructor(e,n,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:NM++}),this.name="",this.array=e,this.itemSize=n,this.count=e!==void 0?e.length/n:0,this.normalized=i,this.usage=Cg,this.updateRanges=[],this.gpuType=$i,this.version=0,this._normalizationScale=e!==void 0?Kf(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,n){this.updateRanges.push({start:e,count:n})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,n,i){e*=this.itemSize,i*=n.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=n.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let n=0,i=this.count;n<i;n++)Kl.fromBufferAttribute(this,n),Kl.applyMatrix3(e),this.setXY(n,Kl.x,Kl.y);else if(this.itemSize===3)for(let n=0,i=this.count;n<i;n++)bn.fromBufferAttribute(this,n),bn.applyMatrix3(e),this.setXYZ(n,bn.x,bn.y,bn.z);return this}applyMatrix4(e){for(let n=0,i=this.count;n<i;n++)bn.fromBufferAttribute(this,n),bn.applyMatrix4(e),this.setXYZ(n,bn.x,bn.y,bn.z);return this}applyNormalMatrix(e){for(let n=0,i=this.count;n<i;n++)bn.fromBufferAttribute(this,n),bn.applyNormalMatrix(e),this.setXYZ(n,bn.x,bn.y,bn.z);return this}transformDirection(e){for(let n=0,i=this.count;n<i;n++)bn.fromBufferAttribute(this,n),bn.transformDirection(e),this.setXYZ(n,bn.x,bn.y,bn.z);return this}set(e,n=0){return this.array.set(e,n),this}getComponent(e,n){let i=this.array[e*this.itemSize+n];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,n,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+n]=i,this}getX(e){let n=this.array[e*this.itemSize];return this.normalized&&(n=this._denormalize(n)),n}setX(e,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize]=n,this}getY(e){let n=this.array[e*this.itemSize+1];return this.normalized&&(n=this._denormalize(n)),n}setY(e,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+1]=n,this}getZ(e){let n=this.array[e*this.itemSize+2];return this.normalized&&(n=this._denormalize(n)),n}setZ(e,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+2]=n,this}getW(e){let n=this.array[e*this.itemSize+3];return this.normalized&&(n=this._denormalize(n)),n}setW(e,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+3]=n,this}setXY(e,n,i){return e*=this.itemSize,this.normalized&&(n=this._normalize(n),i=this._normalize(i)),this.array[e+0]=n,this.array[e+1]=i,this}setXYZ(e,n,i,s){return e*=this.itemSize,this.normalized&&(n=this._normalize(n),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=n,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,n,i,s,r){return e*=this.itemSize,this.normalized&&(n=this._normalize(n),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=n,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let n=this._normalizationScale;return n!==void 0?Math.max(e/n,-1):SM(e,this.array)}_normalize(e){let n=this._normalizationScale;return n!==void 0?Math.round(e*n):MM(e,this.array)}};var Ta=class extends en{constructor(e,n,i){super(new Uint16Array(e),n,i)}};var Ca=class extends en{constructor(e,n,i){super(new Uint32Array(e),n,i)}};var wt=class extends en{constructor(e,n,i){super(new Float32Array(e),n,i)}},DM=new tr,_a=new F,df=new F,Hi=class{constructor(e=new F,n=-1){this.isSphere=!0,this.center=e,this.radius=n}set(e,n){return this.center.copy(e),this.radius=n,this}setFromPoints(e,n){let i=this.center;n!==void 0?i.copy(n):DM.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let n=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=n*n}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,n){let i=this.center.distanceToSquared(e);return n.copy(e),i>this.radius*this.radius&&(n.sub(this.center).normalize(),n.multiplyScalar(this.radius).add(this.center)),n}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;_a.subVectors(e,this.center);let n=_a.lengthSq();if(n>this.radius*this.radius){let i=Math.sqrt(n),s=(i-this.radius)*.5;this.center.addScaledVector(_a,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(df.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(_a.copy(e.center).add(df)),this.expandByPoint(_a.copy(e.center).sub(df))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},UM=0,Ai=new Dt,pf=new gn,fo=new F,mi=new tr,xa=new tr,Bn=new F,jt=class t extends Vi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:UM++}),this.uuid=el(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(xM(e)?Ca:Ta)(e,1):this.index=e,this}setIndirect(e,n=0){return this.indirect=e,this.indirectOffset=n,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,n){return this.attributes[e]=n,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,n,i=0){this.groups.push({start:e,count:n,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,n){this.drawRange.start=e,this.drawRange.count=n}applyMatrix4(e){let n=this.attributes.position;n!==void 0&&(n.applyMatrix4(e),n.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new st().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ai.makeRotationFromQuaternion(e),this.applyMatrix4(Ai),this}rotateX(e){return Ai.makeRotationX(e),this.applyMatrix4(Ai),this}rotateY(e){return Ai.makeRotationY(e),this.applyMatrix4(Ai),this}rotateZ(e){return Ai.makeRotationZ(e),this.applyMatrix4(Ai),this}translate(e,n,i){return Ai.makeTranslation(e,n,i),this.applyMatrix4(Ai),this}scale(e,n,i){return Ai.makeScale(e,n,i),this.applyMatrix4(Ai),this}lookAt(e){return pf.lookAt(e),pf.updateMatrix(),this.applyMatrix4(pf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(fo).negate(),this.translate(fo.x,fo.y,fo.z),this}setFromPoints(e){let n=this.getAttribute("position");if(n===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new wt(i,3))}else{let i=Math.min(e.length,n.count);for(let s=0;s<i;s++){let r=e[s];n.setXYZ(s,r.x,r.y,r.z||0)}e.length>n.count&&Je("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),n.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new tr);let e=this.attributes.position,n=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new F(-1/0,-1/0,-1/0),new F(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),n)for(let i=0,s=n.length;i<s;i++){let r=n[i];mi.setFromBufferAttribute(r),this.morphTargetsRelative?(Bn.addVectors(this.boundingBox.min,mi.min),this.boundingBox.expandByPoint(Bn),Bn.addVectors(this.boundingBox.max,mi.max),this.boundingBox.expandByPoint(Bn)):(this.boundingBox.expandByPoint(mi.min),this.boundingBox.expandByPoint(mi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&tt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Hi);let e=this.attributes.position,n=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new F,1/0);return}if(e){let i=this.boundingSphere.center;if(mi.setFromBufferAttribute(e),n)for(let r=0,o=n.length;r<o;r++){let a=n[r];xa.setFromBufferAttribute(a),this.morphTargetsRelative?(Bn.addVectors(mi.min,xa.min),mi.expandByPoint(Bn),Bn.addVectors(mi.max,xa.max),mi.expandByPoint(Bn)):(mi.expandByPoint(xa.min),mi.expandByPoint(xa.max))}mi.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Bn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Bn));if(n)for(let r=0,o=n.length;r<o;r++){let a=n[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Bn.fromBufferAttribute(a,c),l&&(fo.fromBufferAttribute(e,c),Bn.add(fo)),s=Math.max(s,i.distanceToSquared(Bn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&tt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,n=this.attributes;if(e===null||n.position===void 0||n.normal===void 0||n.uv===void 0){tt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=n.position,s=n.normal,r=n.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new en(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let U=0;U<i.count;U++)a[U]=new F,l[U]=new F;let u=new F,h=new F,f=new F,d=new it,g=new it,y=new it,p=new F,m=new F;function v(U,L,N){c[U]=c[L]=c[N]=1,u.fromBufferAttribute(i,U),h.fromBufferAttribute(i,L),f.fromBufferAttribute(i,N),d.fromBufferAttribute(r,U),g.fromBufferAttribute(r,L),y.fromBufferAttribute(r,N),h.sub(u),f.sub(u),g.sub(d),y.sub(d);let k=1/(g.x*y.y-y.x*g.y);isFinite(k)&&(p.copy(h).multiplyScalar(y.y).addScaledVector(f,-g.y).multiplyScalar(k),m.copy(f).multiplyScalar(g.x).addScaledVector(h,-y.x).multiplyScalar(k),a[U].add(p),a[L].add(p),a[N].add(p),l[U].add(m),l[L].add(m),l[N].add(m))}let T=this.groups;T.length===0&&(T=[{start:0,count:e.count}]);for(let U=0,L=T.length;U<L;++U){let N=T[U],k=N.start,H=N.count;for(let I=k,z=k+H;I<z;I+=3)v(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let S=new F,C=new F,A=new F,_=new F;function w(U){A.fromBufferAttribute(s,U),_.copy(A);let L=a[U];S.copy(L),S.sub(A.multiplyScalar(A.dot(L))).normalize(),C.crossVectors(_,L);let k=C.dot(l[U])<0?-1:1;o.setXYZW(U,S.x,S.y,S.z,k)}for(let U=0,L=i.count;U<L;++U)c[U]&&w(U);this._transformed=!0}computeVertexNormals(){let e=this.index,n=this.getAttribute("position");if(n!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==n.count)i=new en(new Float32Array(n.count*3),3),this.setAttribute("normal",i);else for(let f=0,d=i.count;f<d;f++)i.setXYZ(f,0,0,0);let s=new F,r=new F,o=new F,a=new F,l=new F,c=new F,u=new F,h=new F;if(e)for(let f=0,d=e.count;f<d;f+=3){let g=e.getX(f+0),y=e.getX(f+1),p=e.getX(f+2);s.fromBufferAttribute(n,g),r.fromBufferAttribute(n,y),o.fromBufferAttribute(n,p),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,p),a.add(u),l.add(u),c.add(u),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(p,c.x,c.y,c.z)}else for(let f=0,d=n.count;f<d;f+=3)s.fromBufferAttribute(n,f+0),r.fromBufferAttribute(n,f+1),o.fromBufferAttribute(n,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let n=0,i=e.count;n<i;n++)Bn.fromBufferAttribute(e,n),Bn.normalize(),e.setXYZ(n,Bn.x,Bn.y,Bn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),d=0,g=0;for(let y=0,p=l.length;y<p;y++){a.isInterleavedBufferAttribute?d=l[y]*a.data.stride+a.offset:d=l[y]*u;for(let m=0;m<u;m++)f[g++]=c[d++]}return new en(f,u,h)}if(this.index===null)return Je("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let n=new t,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);n.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],d=e(f,i);l.push(d)}n.morphAttributes[a]=l}n.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];n.addGroup(c.start,c.count,c.materialIndex)}return n}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let n=this.index;n!==null&&(e.data.index={type:n.array.constructor.name,array:Array.prototype.slice.call(n.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let d=c[h];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let n={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(n))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(n));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var mf=new F,FM=new F,OM=new st,Gi=class{constructor(e=new F(1,0,0),n=0){this.isPlane=!0,this.normal=e,this.constant=n}set(e,n){return this.normal.copy(e),this.constant=n,this}setComponents(e,n,i,s){return this.normal.set(e,n,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,n){return this.normal.copy(e),this.constant=-n.dot(this.normal),this}setFromCoplanarPoints(e,n,i){let s=mf.subVectors(i,n).cross(FM.subVectors(e,n)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,n){return n.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,n,i=!0){let s=e.delta(mf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?n.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:n.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let n=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return n<0&&i>0||i<0&&n>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,n){let i=n||OM.getNormalMatrix(e),s=this.coplanarPoint(mf).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},BM=0,Wi=class extends Vi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:BM++}),this.uuid=el(),this.name="",this.type="Material",this.blending=Po,this.side=lr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Lf,this.blendDst=Nf,this.blendEquation=Ar,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new $e(0,0,0),this.blendAlpha=0,this.depthFunc=xo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Mg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=mc,this.stencilZFail=mc,this.stencilZPass=mc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let n in e){let i=e[n];if(i===void 0){Je(`Material: parameter '${n}' has value of undefined.`);continue}let s=this[n];if(s===void 0){Je(`Material: '${n}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[n]=i}}toJSON(e){let n=e===void 0||typeof e=="string";n&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(n){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,n){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new $e().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Gi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=n[e.map]||null),e.matcap!==void 0&&(this.matcap=n[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=n[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=n[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=n[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new it().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=n[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=n[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=n[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=n[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=n[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=n[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=n[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=n[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=n[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=n[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=n[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=n[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=n[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=n[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new it().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=n[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=n[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=n[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=n[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=n[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=n[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=n[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=n[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let n=e.clippingPlanes,i=null;if(n!==null){let s=n.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=n[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var As=new F,gf=new F,Ql=new F,ec=new F,wo=class{constructor(e=new F,n=new F(0,0,-1)){this.origin=e,this.direction=n}set(e,n){return this.origin.copy(e),this.direction.copy(n),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,n){return n.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,As)),this}closestPointToPoint(e,n){n.subVectors(e,this.origin);let i=n.dot(this.direction);return i<0?n.copy(this.origin):n.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let n=As.subVectors(e,this.origin).dot(this.direction);return n<0?this.origin.distanceToSquared(e):(As.copy(this.origin).addScaledVector(this.direction,n),As.distanceToSquared(e))}distanceSqToSegment(e,n,i,s){gf.copy(e).add(n).multiplyScalar(.5),Ql.copy(n).sub(e).normalize(),ec.copy(this.origin).sub(gf);let r=e.distanceTo(n)*.5,o=-this.direction.dot(Ql),a=ec.dot(this.direction),l=-ec.dot(Ql),c=ec.lengthSq(),u=Math.abs(1-o*o),h,f,d,g;if(u>0)if(h=o*l-a,f=o*a-l,g=r*u,h>=0)if(f>=-g)if(f<=g){let y=1/u;h*=y,f*=y,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-g?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c):f<=g?(h=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(gf).addScaledVector(Ql,f),d}intersectSphere(e,n){if(e.radius<0)return null;As.subVectors(e.center,this.origin);let i=As.dot(this.direction),s=As.dot(As)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,n):this.at(a,n)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let n=e.normal.dot(this.direction);if(n===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/n;return i>=0?i:null}intersectPlane(e,n){let i=this.distanceToPlane(e);return i===null?null:this.at(i,n)}intersectsPlane(e){let n=e.distanceToPoint(this.origin);return n===0||e.normal.dot(this.direction)*n<0}intersectBox(e,n){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(i=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(i=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),u>=0?(r=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(r=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,n)}intersectsBox(e){return this.intersectBox(e,As)!==null}intersectTriangle(e,n,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,f=e.y-o.y,d=e.z-o.z,g=n.x-o.x,y=n.y-o.y,p=n.z-o.z,m=i.x-o.x,v=i.y-o.y,T=i.z-o.z,S=Math.abs(l),C=Math.abs(c),A=Math.abs(u),_,w,U,L,N,k,H,I,z,$,V,ae;if(S>=C&&S>=A?(U=l,k=h,z=g,ae=m,l>=0?(_=c,w=u,L=f,N=d,H=y,I=p,$=v,V=T):(_=u,w=c,L=d,N=f,H=p,I=y,$=T,V=v)):C>=A?(U=c,k=f,z=y,ae=v,c>=0?(_=u,w=l,L=d,N=h,H=p,I=g,$=T,V=m):(_=l,w=u,L=h,N=d,H=g,I=p,$=m,V=T)):(U=u,k=d,z=p,ae=T,u>=0?(_=l,w=c,L=h,N=f,H=g,I=y,$=m,V=v):(_=c,w=l,L=f,N=h,H=y,I=g,$=v,V=m)),U===0)return null;let q=_/U,K=w/U,ne=1/U,he=L-q*k,fe=N-K*k,Q=H-q*z,me=I-K*z,xe=$-q*ae,Re=V-K*ae,we=xe*me-Re*Q,Xe=he*Re-fe*xe,at=Q*fe-me*he;if(s){if(we<0||Xe<0||at<0)return null}else if((we<0||Xe<0||at<0)&&(we>0||Xe>0||at>0))return null;let He=we+Xe+at;if(He===0)return null;let dt=ne*(we*k+Xe*z+at*ae);return(He>0?dt<0:dt>0)?null:this.at(dt/He,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Rs=class extends Wi{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new $e(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ci,this.combine=Zc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Nm=new Dt,br=new wo,tc=new Hi,Dm=new F,nc=new F,ic=new F,sc=new F,_f=new F,rc=new F,Um=new F,oc=new F,Me=class extends gn{constructor(e=new jt,n=new Rs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=n,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,n){return super.copy(e,n),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let n=this.geometry.morphAttributes,i=Object.keys(n);if(i.length>0){let s=n[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,n){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;n.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){rc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(_f.fromBufferAttribute(h,e),o?rc.addScaledVector(_f,u):rc.addScaledVector(_f.sub(n),u))}n.add(rc)}return n}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,n){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),tc.copy(i.boundingSphere),tc.applyMatrix4(r),br.copy(e.ray).recast(e.near),!(tc.containsPoint(br.origin)===!1&&(br.intersectSphere(tc,Dm)===null||br.origin.distanceToSquared(Dm)>(e.far-e.near)**2))&&(Nm.copy(r).invert(),br.copy(e.ray).applyMatrix4(Nm),!(i.boundingBox!==null&&br.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,n,br)))}_computeIntersections(e,n,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=f.length;g<y;g++){let p=f[g],m=o[p.materialIndex],v=Math.max(p.start,d.start),T=Math.min(a.count,Math.min(p.start+p.count,d.start+d.count));for(let S=v,C=T;S<C;S+=3){let A=a.getX(S),_=a.getX(S+1),w=a.getX(S+2);s=ac(this,m,e,i,c,u,h,A,_,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=p.materialIndex,n.push(s))}}else{let g=Math.max(0,d.start),y=Math.min(a.count,d.start+d.count);for(let p=g,m=y;p<m;p+=3){let v=a.getX(p),T=a.getX(p+1),S=a.getX(p+2);s=ac(this,o,e,i,c,u,h,v,T,S),s&&(s.faceIndex=Math.floor(p/3),n.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,y=f.length;g<y;g++){let p=f[g],m=o[p.materialIndex],v=Math.max(p.start,d.start),T=Math.min(l.count,Math.min(p.start+p.count,d.start+d.count));for(let S=v,C=T;S<C;S+=3){let A=S,_=S+1,w=S+2;s=ac(this,m,e,i,c,u,h,A,_,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=p.materialIndex,n.push(s))}}else{let g=Math.max(0,d.start),y=Math.min(l.count,d.start+d.count);for(let p=g,m=y;p<m;p+=3){let v=p,T=p+1,S=p+2;s=ac(this,o,e,i,c,u,h,v,T,S),s&&(s.faceIndex=Math.floor(p/3),n.push(s))}}}};function kM(t,e,n,i,s,r,o,a){let l;if(e.side===ri?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===lr,a),l===null)return null;oc.copy(a),oc.applyMatrix4(t.matrixWorld);let c=n.ray.origin.distanceTo(oc);return c<n.near||c>n.far?null:{distance:c,point:oc.clone(),object:t}}function ac(t,e,n,i,s,r,o,a,l,c){t.getVertexPosition(a,nc),t.getVertexPosition(l,ic),t.getVertexPosition(c,sc);let u=kM(t,e,n,i,nc,ic,sc,Um);if(u){let h=new F;er.getBarycoord(Um,nc,ic,sc,h),s&&(u.uv=er.getInterpolatedAttribute(s,a,l,c,h,new it)),r&&(u.uv1=er.getInterpolatedAttribute(r,a,l,c,h,new it)),o&&(u.normal=er.getInterpolatedAttribute(o,a,l,c,h,new F),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new F,materialIndex:0};er.getNormal(nc,ic,sc,f.normal),u.face=f,u.barycoord=h}return u}var Eo=class extends li{constructor(e=null,n=1,i=1,s,r,o,a,l,c=kn,u=kn,h,f){super(null,o,a,l,c,u,s,r,h,f),this.isDataTexture=!0,this.image={data:e,width:n,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var wr=new Hi,zM=new it(.5,.5),lc=new F,nr=class{constructor(e=new Gi,n=new Gi,i=new Gi,s=new Gi,r=new Gi,o=new Gi){this.planes=[e,n,i,s,r,o]}set(e,n,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(n),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let n=this.planes;for(let i=0;i<6;i++)n[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,n=Ti,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],d=r[7],g=r[8],y=r[9],p=r[10],m=r[11],v=r[12],T=r[13],S=r[14],C=r[15];if(s[0].setComponents(c-o,d-u,m-g,C-v).normalize(),s[1].setComponents(c+o,d+u,m+g,C+v).normalize(),s[2].setComponents(c+a,d+h,m+y,C+T).normalize(),s[3].setComponents(c-a,d-h,m-y,C-T).normalize(),i)s[4].setComponents(l,f,p,S).normalize(),s[5].setComponents(c-l,d-f,m-p,C-S).normalize();else if(s[4].setComponents(c-l,d-f,m-p,C-S).normalize(),n===Ti)s[5].setComponents(c+l,d+f,m+p,C+S).normalize();else if(n===vo)s[5].setComponents(l,f,p,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+n);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),wr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let n=e.geometry;n.boundingSphere===null&&n.computeBoundingSphere(),wr.copy(n.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(wr)}intersectsSprite(e){wr.center.set(0,0,0);let n=zM.distanceTo(e.center);return wr.radius=.7071067811865476+n,wr.applyMatrix4(e.matrixWorld),this.intersectsSphere(wr)}intersectsSphere(e){let n=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(n[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let n=this.planes;for(let i=0;i<6;i++){let s=n[i];if(lc.x=s.normal.x>0?e.max.x:e.min.x,lc.y=s.normal.y>0?e.max.y:e.min.y,lc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(lc)<0)return!1}return!0}containsPoint(e){let n=this.planes;for(let i=0;i<6;i++)if(n[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Fm=new Dt,Pc=class t{constructor(){this.coordinateSystem=Ti,this._frustums=[],this._count=0}setFromArrayCamera(e){let n=e.cameras,i=this._frustums;for(let s=0;s<n.length;s++){let r=n[s];Fm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new nr),i[s].setFromProjectionMatrix(Fm,r.coordinateSystem,r.reversedDepth)}return this._count=n.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let n=this._frustums;for(let i=0;i<this._count;i++)if(n[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let n=this._frustums;for(let i=0;i<this._count;i++)if(n[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let n=this._frustums;for(let i=0;i<this._count;i++)if(n[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let n=this._frustums;for(let i=0;i<this._count;i++)if(n[i].intersectsBox(e))return!0;return!1}containsPoint(e){let n=this._frustums;for(let i=0;i<this._count;i++)if(n[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let n=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)n[s]===void 0&&(n[s]=new nr),n[s].copy(i[s]);return this._count=e._count,this}clone(){return new t().copy(this)}};var ir=class extends Wi{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new $e(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Ic=new F,Lc=new F,Om=new Dt,va=new wo,cc=new Hi,xf=new F,Bm=new F,_i=class extends gn{constructor(e=new jt,n=new ir){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=n,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,n){return super.copy(e,n),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let n=e.attributes.position,i=[0];for(let s=1,r=n.count;s<r;s++)Ic.fromBufferAttribute(n,s-1),Lc.fromBufferAttribute(n,s),i[s]=i[s-1],i[s]+=Ic.distanceTo(Lc);e.setAttribute("lineDistance",new wt(i,1))}else Je("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,n){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),cc.copy(i.boundingSphere),cc.applyMatrix4(s),cc.radius+=r,e.ray.intersectsSphere(cc)===!1)return;Om.copy(s).invert(),va.copy(e.ray).applyMatrix4(Om);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,f=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let y=d,p=g-1;y<p;y+=c){let m=u.getX(y),v=u.getX(y+1),T=uc(this,e,va,l,m,v,y);T&&n.push(T)}if(this.isLineLoop){let y=u.getX(g-1),p=u.getX(d),m=uc(this,e,va,l,y,p,g-1);m&&n.push(m)}}else{let d=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let y=d,p=g-1;y<p;y+=c){let m=uc(this,e,va,l,y,y+1,y);m&&n.push(m)}if(this.isLineLoop){let y=uc(this,e,va,l,g-1,d,g-1);y&&n.push(y)}}}updateMorphTargets(){let n=this.geometry.morphAttributes,i=Object.keys(n);if(i.length>0){let s=n[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function uc(t,e,n,i,s,r,o){let a=t.geometry.attributes.position;if(Ic.fromBufferAttribute(a,s),Lc.fromBufferAttribute(a,r),n.distanceSqToSegment(Ic,Lc,xf,Bm)>i)return;xf.applyMatrix4(t.matrixWorld);let c=e.ray.origin.distanceTo(xf);if(!(c<e.near||c>e.far))return{distance:c,point:Bm.clone().applyMatrix4(t.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:t}}var km=new F,zm=new F,Ra=class extends _i{constructor(e,n){super(e,n),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let n=e.attributes.position,i=[];for(let s=0,r=n.count;s<r;s+=2)km.fromBufferAttribute(n,s),zm.fromBufferAttribute(n,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+km.distanceTo(zm);e.setAttribute("lineDistance",new wt(i,1))}else Je("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Pa=class extends li{constructor(e=[],n=Tr,i,s,r,o,a,l,c,u){super(e,n,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ps=class extends li{constructor(e,n,i=qi,s,r,o,a=kn,l=kn,c,u=Cs,h=1){if(u!==Cs&&u!==Fs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:n,depth:h};super(f,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new So(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let n=super.toJSON(e);return n.compareFunction=this.compareFunction,n}},Ia=class extends Ps{constructor(e,n=qi,i=Tr,s,r,o=kn,a=kn,l,c=Cs){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,n,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},La=class extends li{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},hn=class t extends jt{constructor(e=1,n=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:n,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,d=0;g("z","y","x",-1,-1,i,n,e,o,r,0),g("z","y","x",1,-1,i,n,-e,o,r,1),g("x","z","y",1,1,e,i,n,s,o,2),g("x","z","y",1,-1,e,i,-n,s,o,3),g("x","y","z",1,-1,e,n,i,s,r,4),g("x","y","z",-1,-1,e,n,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new wt(c,3)),this.setAttribute("normal",new wt(u,3)),this.setAttribute("uv",new wt(h,2));function g(y,p,m,v,T,S,C,A,_,w,U){let L=S/_,N=C/w,k=S/2,H=C/2,I=A/2,z=_+1,$=w+1,V=0,ae=0,q=new F;for(let K=0;K<$;K++){let ne=K*N-H;for(let he=0;he<z;he++){let fe=he*L-k;q[y]=fe*v,q[p]=ne*T,q[m]=I,c.push(q.x,q.y,q.z),q[y]=0,q[p]=0,q[m]=A>0?1:-1,u.push(q.x,q.y,q.z),h.push(he/_),h.push(1-K/w),V+=1}}for(let K=0;K<w;K++)for(let ne=0;ne<_;ne++){let he=f+ne+z*K,fe=f+ne+z*(K+1),Q=f+(ne+1)+z*(K+1),me=f+(ne+1)+z*K;l.push(he,fe,me),l.push(fe,Q,me),ae+=6}a.addGroup(d,ae,U),d+=ae,f+=V}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new t(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Na=class t extends jt{constructor(e=1,n=32,i=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:e,segments:n,thetaStart:i,thetaLength:s},n=Math.max(3,n);let r=[],o=[],a=[],l=[],c=new F,u=new it;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let h=0,f=3;h<=n;h++,f+=3){let d=i+h/n*s;c.x=e*Math.cos(d),c.y=e*Math.sin(d),o.push(c.x,c.y,c.z),a.push(0,0,1),u.x=(o[f]/e+1)/2,u.y=(o[f+1]/e+1)/2,l.push(u.x,u.y)}for(let h=1;h<=n;h++)r.push(h,h+1,0);this.setIndex(r),this.setAttribute("position",new wt(o,3)),this.setAttribute("normal",new wt(a,3)),this.setAttribute("uv",new wt(l,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new t(e.radius,e.segments,e.thetaStart,e.thetaLength)}},Wt=class t extends jt{constructor(e=1,n=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:n,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],f=[],d=[],g=0,y=[],p=i/2,m=0;v(),o===!1&&(e>0&&T(!0),n>0&&T(!1)),this.setIndex(u),this.setAttribute("position",new wt(h,3)),this.setAttribute("normal",new wt(f,3)),this.setAttribute("uv",new wt(d,2));function v(){let S=new F,C=new F,A=0,_=(n-e)/i;for(let w=0;w<=r;w++){let U=[],L=w/r,N=L*(n-e)+e;for(let k=0;k<=s;k++){let H=k/s,I=H*l+a,z=Math.sin(I),$=Math.cos(I);C.x=N*z,C.y=-L*i+p,C.z=N*$,h.push(C.x,C.y,C.z),S.set(z,_,$).normalize(),f.push(S.x,S.y,S.z),d.push(H,1-L),U.push(g++)}y.push(U)}for(let w=0;w<s;w++)for(let U=0;U<r;U++){let L=y[U][w],N=y[U+1][w],k=y[U+1][w+1],H=y[U][w+1];(e>0||U!==0)&&(u.push(L,N,H),A+=3),(n>0||U!==r-1)&&(u.push(N,k,H),A+=3)}c.addGroup(m,A,0),m+=A}function T(S){let C=g,A=new it,_=new F,w=0,U=S===!0?e:n,L=S===!0?1:-1;for(let k=1;k<=s;k++)h.push(0,p*L,0),f.push(0,L,0),d.push(.5,.5),g++;let N=g;for(let k=0;k<=s;k++){let I=k/s*l+a,z=Math.cos(I),$=Math.sin(I);_.x=U*$,_.y=p*L,_.z=U*z,h.push(_.x,_.y,_.z),f.push(0,L,0),A.x=z*.5+.5,A.y=$*.5*L+.5,d.push(A.x,A.y),g++}for(let k=0;k<s;k++){let H=C+k,I=N+k;S===!0?u.push(I,I+1,H):u.push(I+1,I,H),w+=3}c.addGroup(m,w,S===!0?1:2),m+=w}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new t(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Is=class t extends Wt{constructor(e=1,n=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,n,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:n,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new t(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Nc=class t extends jt{constructor(e=[],n=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:n,radius:i,detail:s};let r=[],o=[];a(s),c(i),u(),this.setAttribute("position",new wt(r,3)),this.setAttribute("normal",new wt(r.slice(),3)),this.setAttribute("uv",new wt(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(v){let T=new F,S=new F,C=new F;for(let A=0;A<n.length;A+=3)d(n[A+0],T),d(n[A+1],S),d(n[A+2],C),l(T,S,C,v)}function l(v,T,S,C){let A=C+1,_=[];for(let w=0;w<=A;w++){_[w]=[];let U=v.clone().lerp(S,w/A),L=T.clone().lerp(S,w/A),N=A-w;for(let k=0;k<=N;k++)k===0&&w===A?_[w][k]=U:_[w][k]=U.clone().lerp(L,k/N)}for(let w=0;w<A;w++)for(let U=0;U<2*(A-w)-1;U++){let L=Math.floor(U/2);U%2===0?(f(_[w][L+1]),f(_[w+1][L]),f(_[w][L])):(f(_[w][L+1]),f(_[w+1][L+1]),f(_[w+1][L]))}}function c(v){let T=new F;for(let S=0;S<r.length;S+=3)T.x=r[S+0],T.y=r[S+1],T.z=r[S+2],T.normalize().multiplyScalar(v),r[S+0]=T.x,r[S+1]=T.y,r[S+2]=T.z}function u(){let v=new F;for(let T=0;T<r.length;T+=3){v.x=r[T+0],v.y=r[T+1],v.z=r[T+2];let S=p(v)/2/Math.PI+.5,C=m(v)/Math.PI+.5;o.push(S,1-C)}g(),h()}function h(){for(let v=0;v<o.length;v+=6){let T=o[v+0],S=o[v+2],C=o[v+4],A=Math.max(T,S,C),_=Math.min(T,S,C);A>.9&&_<.1&&(T<.2&&(o[v+0]+=1),S<.2&&(o[v+2]+=1),C<.2&&(o[v+4]+=1))}}function f(v){r.push(v.x,v.y,v.z)}function d(v,T){let S=v*3;T.x=e[S+0],T.y=e[S+1],T.z=e[S+2]}function g(){let v=new F,T=new F,S=new F,C=new F,A=new it,_=new it,w=new it;for(let U=0,L=0;U<r.length;U+=9,L+=6){v.set(r[U+0],r[U+1],r[U+2]),T.set(r[U+3],r[U+4],r[U+5]),S.set(r[U+6],r[U+7],r[U+8]),A.set(o[L+0],o[L+1]),_.set(o[L+2],o[L+3]),w.set(o[L+4],o[L+5]),C.copy(v).add(T).add(S).divideScalar(3);let N=p(C);y(A,L+0,v,N),y(_,L+2,T,N),y(w,L+4,S,N)}}function y(v,T,S,C){C<0&&v.x===1&&(o[T]=v.x-1),S.x===0&&S.z===0&&(o[T]=C/2/Math.PI+.5)}function p(v){return Math.atan2(v.z,-v.x)}function m(v){return Math.atan2(-v.y,Math.sqrt(v.x*v.x+v.z*v.z))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new t(e.vertices,e.indices,e.radius,e.detail)}};var sr=class t extends Nc{constructor(e=1,n=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,e,n),this.type="OctahedronGeometry",this.parameters={radius:e,detail:n}}static fromJSON(e){return new t(e.radius,e.detail)}},Ls=class t extends jt{constructor(e=1,n=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:n,widthSegments:i,heightSegments:s};let r=e/2,o=n/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,f=n/l,d=[],g=[],y=[],p=[];for(let m=0;m<u;m++){let v=m*f-o;for(let T=0;T<c;T++){let S=T*h-r;g.push(S,-v,0),y.push(0,0,1),p.push(T/a),p.push(1-m/l)}}for(let m=0;m<l;m++)for(let v=0;v<a;v++){let T=v+c*m,S=v+c*(m+1),C=v+1+c*(m+1),A=v+1+c*m;d.push(T,S,A),d.push(S,C,A)}this.setIndex(d),this.setAttribute("position",new wt(g,3)),this.setAttribute("normal",new wt(y,3)),this.setAttribute("uv",new wt(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new t(e.width,e.height,e.widthSegments,e.heightSegments)}};var us=class t extends jt{constructor(e=1,n=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:n,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},n=Math.max(3,Math.floor(n)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new F,f=new F,d=[],g=[],y=[],p=[];for(let m=0;m<=i;m++){let v=[],T=m/i,S=o+T*a,C=e*Math.cos(S),A=Math.sqrt(e*e-C*C),_=0;m===0&&o===0?_=.5/n:m===i&&l===Math.PI&&(_=-.5/n);for(let w=0;w<=n;w++){let U=w/n,L=s+U*r;h.x=-A*Math.cos(L),h.y=C,h.z=A*Math.sin(L),g.push(h.x,h.y,h.z),f.copy(h).normalize(),y.push(f.x,f.y,f.z),p.push(U+_,1-T),v.push(c++)}u.push(v)}for(let m=0;m<i;m++)for(let v=0;v<n;v++){let T=u[m][v+1],S=u[m][v],C=u[m+1][v],A=u[m+1][v+1];(m!==0||o>0)&&d.push(T,S,A),(m!==i-1||l<Math.PI)&&d.push(S,C,A)}this.setIndex(d),this.setAttribute("position",new wt(g,3)),this.setAttribute("normal",new wt(y,3)),this.setAttribute("uv",new wt(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new t(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var Xi=class t extends jt{constructor(e=1,n=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:n,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],h=[],f=new F,d=new F,g=new F;for(let y=0;y<=i;y++){let p=o+y/i*a;for(let m=0;m<=s;m++){let v=m/s*r;d.x=(e+n*Math.cos(p))*Math.cos(v),d.y=(e+n*Math.cos(p))*Math.sin(v),d.z=n*Math.sin(p),c.push(d.x,d.y,d.z),f.x=e*Math.cos(v),f.y=e*Math.sin(v),g.subVectors(d,f).normalize(),u.push(g.x,g.y,g.z),h.push(m/s),h.push(y/i)}}for(let y=1;y<=i;y++)for(let p=1;p<=s;p++){let m=(s+1)*y+p-1,v=(s+1)*(y-1)+p-1,T=(s+1)*(y-1)+p,S=(s+1)*y+p;l.push(m,v,S),l.push(v,T,S)}this.setIndex(l),this.setAttribute("position",new wt(c,3)),this.setAttribute("normal",new wt(u,3)),this.setAttribute("uv",new wt(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new t(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};var Da=class extends Wi{constructor(e){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new $e(0),this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.fog=e.fog,this}};function Rr(t){let e={};for(let n in t){e[n]={};for(let i in t[n]){let s=t[n][i];if(Gm(s))s.isRenderTargetTexture?(Je("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[n][i]=null):e[n][i]=s.clone();else if(Array.isArray(s))if(Gm(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[n][i]=r}else e[n][i]=s.slice();else e[n][i]=s}}return e}function Yn(t){let e={};for(let n=0;n<t.length;n++){let i=Rr(t[n]);for(let s in i)e[s]=i[s]}return e}function Gm(t){return t&&(t.isColor||t.isMatrix3||t.isMatrix4||t.isVector2||t.isVector3||t.isVector4||t.isTexture||t.isQuaternion)}function GM(t){let e=[];for(let n=0;n<t.length;n++)e.push(t[n].clone());return e}function Qf(t){let e=t.getRenderTarget();return e===null?t.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:xt.workingColorSpace}var Ug={clone:Rr,merge:Yn},VM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,HM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Vn=class extends Wi{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=VM,this.fragmentShader=HM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Rr(e.uniforms),this.uniformsGroups=GM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let n=super.toJSON(e);n.glslVersion=this.glslVersion,n.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?n.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?n.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?n.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?n.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?n.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?n.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?n.uniforms[s]={type:"m4",value:o.toArray()}:n.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(n.defines=this.defines),n.vertexShader=this.vertexShader,n.fragmentShader=this.fragmentShader,n.lights=this.lights,n.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(n.extensions=i),n}fromJSON(e,n){if(super.fromJSON(e,n),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=n[s.value]||null;break;case"c":this.uniforms[i].value=new $e().setHex(s.value);break;case"v2":this.uniforms[i].value=new it().fromArray(s.value);break;case"v3":this.uniforms[i].value=new F().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Ht().fromArray(s.value);break;case"m3":this.uniforms[i].value=new st().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Dt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Dc=class extends Vn{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Ua=class extends Wi{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new $e(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new $e(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ka,this.normalScale=new it(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ci,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Fa=class extends Wi{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new $e(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new $e(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ka,this.normalScale=new it(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ci,this.combine=Zc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Uc=class extends Wi{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=yg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Fc=class extends Wi{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function po(t,e){return!t||t.constructor===e?t:typeof e.BYTES_PER_ELEMENT=="number"?new e(t):Array.prototype.slice.call(t)}function hc(t){return t!==void 0&&t.inTangents!==void 0&&t.outTangents!==void 0}var rr=class{constructor(e,n,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new n.constructor(i),this.sampleValues=n,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let n=this.parameterPositions,i=this._cachedIndex,s=n[i],r=n[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=n.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=n[++i],e<s)break e}o=n.length;break t}if(!(e>=r)){let a=n[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=n[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<n[a]?o=a:i=a+1}if(s=n[i],r=n[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=n.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let n=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)n[o]=i[r+o];return n}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Oc=class extends rr{constructor(e,n,i,s){super(e,n,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Sf,endingEnd:Sf}}intervalChanged_(e,n,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Mf:r=e,a=2*n-i;break;case bf:r=s.length-2,a=n+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Mf:o=e,l=2*i-n;break;case bf:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=n}let c=(i-n)*.5,u=this.valueSize;this._weightPrev=c/(n-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,n,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,d=this._weightNext,g=(i-n)/(s-n),y=g*g,p=y*g,m=-f*p+2*f*y-f*g,v=(1+f)*p+(-1.5-2*f)*y+(-.5+f)*g+1,T=(-1-d)*p+(1.5+d)*y+.5*g,S=d*p-d*y;for(let C=0;C!==a;++C)r[C]=m*o[u+C]+v*o[c+C]+T*o[l+C]+S*o[h+C];return r}},Bc=class extends rr{constructor(e,n,i,s){super(e,n,i,s)}interpolate_(e,n,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-n)/(s-n),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},kc=class extends rr{constructor(e,n,i,s){super(e,n,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},zc=class extends rr{interpolate_(e,n,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let g=(i-n)/(s-n),y=1-g;for(let p=0;p!==a;++p)r[p]=o[c+p]*y+o[l+p]*g;return r}let f=a*2,d=e-1;for(let g=0;g!==a;++g){let y=o[c+g],p=o[l+g],m=d*f+g*2,v=h[m],T=h[m+1],S=e*f+g*2,C=u[S],A=u[S+1],_=XM(i,n,v,C,s);r[g]=Fg(_,y,T,A,p)}return r}};function Fg(t,e,n,i,s){let r=1-t;return r*r*r*e+3*r*r*t*n+3*r*t*t*i+t*t*t*s}function WM(t,e,n,i,s){let r=1-t;return 3*r*r*(n-e)+6*r*t*(i-n)+3*t*t*(s-i)}function XM(t,e,n,i,s){let r=(t-e)/(s-e);for(let o=0;o<8;o++){let a=Fg(r,e,n,i,s)-t;if(Math.abs(a)<1e-10)break;let l=WM(r,e,n,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var xi=class{constructor(e,n,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(n===void 0||n.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=po(n,this.TimeBufferType),this.values=po(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let n=e.constructor,i;if(n.toJSON!==this.toJSON)i=n.toJSON(e);else{i={name:e.name,times:po(e.times,Array),values:po(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),hc(e.settings)&&(i.settings={inTangents:po(e.settings.inTangents,Array),outTangents:po(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new kc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Bc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Oc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let n=new zc(this.times,this.values,this.getValueSize(),e);return this.settings&&(n.inTangents=this.settings.inTangents,n.outTangents=this.settings.outTangents),n}setInterpolation(e){let n;switch(e){case Sa:n=this.InterpolantFactoryMethodDiscrete;break;case Ec:n=this.InterpolantFactoryMethodLinear;break;case pc:n=this.InterpolantFactoryMethodSmooth;break;case yf:n=this.InterpolantFactoryMethodBezier;break}if(n===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Je("KeyframeTrack:",i),this}return this.createInterpolant=n,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Sa;case this.InterpolantFactoryMethodLinear:return Ec;case this.InterpolantFactoryMethodSmooth:return pc;case this.InterpolantFactoryMethodBezier:return yf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let n=this.times;for(let i=0,s=n.length;i!==s;++i)n[i]+=e;hc(this.settings)&&(Vm(this.settings.inTangents,e),Vm(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let n=this.times;for(let i=0,s=n.length;i!==s;++i)n[i]*=e;hc(this.settings)&&(Hm(this.settings.inTangents,e),Hm(this.settings.outTangents,e))}return this}trim(e,n){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>n;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,n=this.getValueSize();n-Math.floor(n)!==0&&(tt("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(tt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){tt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){tt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&vM(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){tt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),n=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===pc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*i,f=h-i,d=h+i;for(let g=0;g!==i;++g){let y=n[h+g];if(y!==n[f+g]||y!==n[d+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,f=o*i;for(let d=0;d!==i;++d)n[f+d]=n[h+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)n[l+c]=n[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=n.slice(0,o*i)):(this.times=e,this.values=n),this}clone(){let e=this.times.slice(),n=this.values.slice(),i=this.constructor,s=new i(this.name,e,n);return s.createInterpolant=this.createInterpolant,hc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Vm(t,e){for(let n=0,i=t.length;n!==i;n+=2)t[n]+=e}function Hm(t,e){for(let n=0,i=t.length;n!==i;n+=2)t[n]*=e}xi.prototype.ValueTypeName="";xi.prototype.TimeBufferType=Float32Array;xi.prototype.ValueBufferType=Float32Array;xi.prototype.DefaultInterpolation=Ec;var or=class extends xi{constructor(e,n,i){super(e,n,i)}};or.prototype.ValueTypeName="bool";or.prototype.ValueBufferType=Array;or.prototype.DefaultInterpolation=Sa;or.prototype.InterpolantFactoryMethodLinear=void 0;or.prototype.InterpolantFactoryMethodSmooth=void 0;var Gc=class extends xi{constructor(e,n,i,s){super(e,n,i,s)}};Gc.prototype.ValueTypeName="color";var Vc=class extends xi{constructor(e,n,i,s){super(e,n,i,s)}};Vc.prototype.ValueTypeName="number";var Hc=class extends rr{constructor(e,n,i,s){super(e,n,i,s)}interpolate_(e,n,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-n)/(s-n),c=e*a;for(let u=c+a;c!==u;c+=4)Tt.slerpFlat(r,0,o,c-a,o,c,l);return r}},Oa=class extends xi{constructor(e,n,i,s){super(e,n,i,s)}InterpolantFactoryMethodLinear(e){return new Hc(this.times,this.values,this.getValueSize(),e)}};Oa.prototype.ValueTypeName="quaternion";Oa.prototype.InterpolantFactoryMethodSmooth=void 0;var ar=class extends xi{constructor(e,n,i){super(e,n,i)}};ar.prototype.ValueTypeName="string";ar.prototype.ValueBufferType=Array;ar.prototype.DefaultInterpolation=Sa;ar.prototype.InterpolantFactoryMethodLinear=void 0;ar.prototype.InterpolantFactoryMethodSmooth=void 0;var Wc=class extends xi{constructor(e,n,i,s){super(e,n,i,s)}};Wc.prototype.ValueTypeName="vector";var Xc=class{constructor(e,n,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=n,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let d=c[h],g=c[h+1];if(d.global&&(d.lastIndex=0),d.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Og=new Xc,qc=class{constructor(e){this.manager=e!==void 0?e:Og,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,n){let i=this;return new Promise(function(s,r){i.load(e,s,n,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};qc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ao=class extends gn{static registerNode(e){this.prototype._lightNode=e}constructor(e,n=1){super(),this.isLight=!0,this.type="Light",this.color=new $e(e),this.intensity=n}copy(e,n){return super.copy(e,n),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let n=super.toJSON(e);return n.object.color=this.color.getHex(),n.object.intensity=this.intensity,n}},Ba=class extends Ao{constructor(e,n,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(gn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new $e(n)}copy(e,n){return super.copy(e,n),this.groundColor.copy(e.groundColor),this}toJSON(e){let n=super.toJSON(e);return n.object.groundColor=this.groundColor.getHex(),n}},vf=new Dt,Wm=new F,Xm=new F,$c=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new it(512,512),this.mapType=$n,this.map=null,this.mapPass=null,this.matrix=new Dt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new nr,this._frameExtents=new it(1,1),this._viewportCount=1,this._viewports=[new Ht(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let n=this.camera;Wm.setFromMatrixPosition(e.matrixWorld),n.position.copy(Wm),Xm.setFromMatrixPosition(e.target.matrixWorld),n.lookAt(Xm),n.updateMatrixWorld(),this._updateMatrix(n,this.matrix,this._frustum)}_updateMatrix(e,n,i,s){vf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(vf,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===vo||e.reversedDepth?n.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):n.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),n.multiply(vf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},fc=new F,dc=new Tt,ls=new F,ka=class extends gn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Dt,this.projectionMatrix=new Dt,this.projectionMatrixInverse=new Dt,this.coordinateSystem=Ti,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,n){return super.copy(e,n),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(fc,dc,ls),ls.x===1&&ls.y===1&&ls.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(fc,dc,ls.set(1,1,1)).invert()}updateWorldMatrix(e,n,i=!1){super.updateWorldMatrix(e,n,i),this.matrixWorld.decompose(fc,dc,ls),ls.x===1&&ls.y===1&&ls.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(fc,dc,ls.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Qs=new F,qm=new it,$m=new it,ii=class extends ka{constructor(e=50,n=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=n,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,n){return super.copy(e,n),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let n=.5*this.getFilmHeight()/e;this.fov=Ac*2*Math.atan(n),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(jh*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Ac*2*Math.atan(Math.tan(jh*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,n,i){Qs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Qs.x,Qs.y).multiplyScalar(-e/Qs.z),Qs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Qs.x,Qs.y).multiplyScalar(-e/Qs.z)}getViewSize(e,n){return this.getViewBounds(e,qm,$m),n.subVectors($m,qm)}setViewOffset(e,n,i,s,r,o){this.aspect=e/n,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=n,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,n=e*Math.tan(jh*.5*this.fov)/this.zoom,i=2*n,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,n-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,n,n-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let n=super.toJSON(e);return n.object.fov=this.fov,n.object.zoom=this.zoom,n.object.near=this.near,n.object.far=this.far,n.object.focus=this.focus,n.object.aspect=this.aspect,this.view!==null&&(n.object.view=Object.assign({},this.view)),n.object.filmGauge=this.filmGauge,n.object.filmOffset=this.filmOffset,n}};var za=class extends ka{constructor(e=-1,n=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=n,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,n){return super.copy(e,n),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,n,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=n,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),n=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+n,l=s-n;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let n=super.toJSON(e);return n.object.zoom=this.zoom,n.object.left=this.left,n.object.right=this.right,n.object.top=this.top,n.object.bottom=this.bottom,n.object.near=this.near,n.object.far=this.far,this.view!==null&&(n.object.view=Object.assign({},this.view)),n}},wf=class extends $c{constructor(){super(new za(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},To=class extends Ao{constructor(e,n){super(e,n),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(gn.DEFAULT_UP),this.updateMatrix(),this.target=new gn,this.shadow=new wf}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let n=super.toJSON(e);return n.object.shadow=this.shadow.toJSON(),n.object.target=this.target.uuid,n}},Ga=class extends Ao{constructor(e,n){super(e,n),this.isAmbientLight=!0,this.type="AmbientLight"}};var mo=-90,go=1,Co=class extends gn{constructor(e,n,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ii(mo,go,e,n);s.layers=this.layers,this.add(s);let r=new ii(mo,go,e,n);r.layers=this.layers,this.add(r);let o=new ii(mo,go,e,n);o.layers=this.layers,this.add(o);let a=new ii(mo,go,e,n);a.layers=this.layers,this.add(a);let l=new ii(mo,go,e,n);l.layers=this.layers,this.add(l);let c=new ii(mo,go,e,n);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,n=this.children.concat(),[i,s,r,o,a,l]=n;for(let c of n)this.remove(c);if(e===Ti)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===vo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of n)this.add(c),c.updateMatrixWorld()}update(e,n){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(n,r),e.setRenderTarget(i,1,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(n,o),e.setRenderTarget(i,2,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(n,a),e.setRenderTarget(i,3,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(n,l),e.setRenderTarget(i,4,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(n,c),i.texture.mipmapsAutoUpdate=y,e.setRenderTarget(i,5,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(n,u),e.setRenderTarget(h,f,d),e.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},Yc=class extends ii{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var ed="\\[\\]\\.:\\/",qM=new RegExp("["+ed+"]","g"),td="[^"+ed+"]",$M="[^"+ed.replace("\\.","")+"]",YM=/((?:WC+[\/:])*)/.source.replace("WC",td),ZM=/(WCOD+)?/.source.replace("WCOD",$M),jM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",td),JM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",td),KM=new RegExp("^"+YM+ZM+jM+JM+"$"),QM=["material","materials","bones","map"],Ef=class{constructor(e,n,i){let s=i||Zt.parseTrackName(n);this._targetGroup=e,this._bindings=e.subscribe_(n,s)}getValue(e,n){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,n)}setValue(e,n){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,n)}bind(){let e=this._bindings;for(let n=this._targetGroup.nCachedObjects_,i=e.length;n!==i;++n)e[n].bind()}unbind(){let e=this._bindings;for(let n=this._targetGroup.nCachedObjects_,i=e.length;n!==i;++n)e[n].unbind()}},Zt=class t{constructor(e,n,i){this.path=n,this.parsedPath=i||t.parseTrackName(n),this.node=t.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,n,i){return e&&e.isAnimationObjectGroup?new t.Composite(e,n,i):new t(e,n,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(qM,"")}static parseTrackName(e){let n=KM.exec(e);if(n===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:n[2],objectName:n[3],objectIndex:n[4],propertyName:n[5],propertyIndex:n[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);QM.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,n){if(n===void 0||n===""||n==="."||n===-1||n===e.name||n===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(n);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===n||a.uuid===n)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,n){e[n]=this.targetObject[this.propertyName]}_getValue_array(e,n){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[n++]=i[s]}_getValue_arrayElement(e,n){e[n]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,n){this.resolvedProperty.toArray(e,n)}_setValue_direct(e,n){this.targetObject[this.propertyName]=e[n]}_setValue_direct_setNeedsUpdate(e,n){this.targetObject[this.propertyName]=e[n],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,n){this.targetObject[this.propertyName]=e[n],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,n){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[n++]}_setValue_array_setNeedsUpdate(e,n){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[n++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,n){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[n++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,n){this.resolvedProperty[this.propertyIndex]=e[n]}_setValue_arrayElement_setNeedsUpdate(e,n){this.resolvedProperty[this.propertyIndex]=e[n],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,n){this.resolvedProperty[this.propertyIndex]=e[n],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,n){this.resolvedProperty.fromArray(e,n)}_setValue_fromArray_setNeedsUpdate(e,n){this.resolvedProperty.fromArray(e,n),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,n){this.resolvedProperty.fromArray(e,n),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,n){this.bind(),this.getValue(e,n)}_setValue_unbound(e,n){this.bind(),this.setValue(e,n)}bind(){let e=this.node,n=this.parsedPath,i=n.objectName,s=n.propertyName,r=n.propertyIndex;if(e||(e=t.findNode(this.rootNode,n.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Je("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=n.objectIndex;switch(i){case"materials":if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){tt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){tt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){tt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){tt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){tt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=n.nodeName;tt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Zt.Composite=Ef;Zt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Zt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Zt.prototype.GetterByBindingType=[Zt.prototype._getValue_direct,Zt.prototype._getValue_array,Zt.prototype._getValue_arrayElement,Zt.prototype._getValue_toArray];Zt.prototype.SetterByBindingTypeAndVersioning=[[Zt.prototype._setValue_direct,Zt.prototype._setValue_direct_setNeedsUpdate,Zt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_array,Zt.prototype._setValue_array_setNeedsUpdate,Zt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_arrayElement,Zt.prototype._setValue_arrayElement_setNeedsUpdate,Zt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_fromArray,Zt.prototype._setValue_fromArray_setNeedsUpdate,Zt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var E2=new Float32Array(1);var Ym=new Dt,Ns=class{constructor(e,n,i=0,s=1/0){this.ray=new wo(e,n),this.near=i,this.far=s,this.camera=null,this.layers=new Mo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,n){this.ray.set(e,n)}setFromCamera(e,n){n.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(n.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(n).sub(this.ray.origin).normalize(),this.camera=n):n.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,n.projectionMatrix.elements[14]).unproject(n),this.ray.direction.set(0,0,-1).transformDirection(n.matrixWorld),this.camera=n):tt("Raycaster: Unsupported camera type: "+n.type)}setFromXRController(e){return Ym.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Ym),this}intersectObject(e,n=!0,i=[]){return Af(e,this,i,n),i.sort(Zm),i}intersectObjects(e,n=!0,i=[]){for(let s=0,r=e.length;s<r;s++)Af(e[s],this,i,n);return i.sort(Zm),i}};function Zm(t,e){return t.distance-e.distance}function Af(t,e,n,i){let s=!0;if(t.layers.test(e.layers)&&t.raycast(e,n)===!1&&(s=!1),s===!0&&i===!0){let r=t.children;for(let o=0,a=r.length;o<a;o++)Af(r[o],e,n,!0)}}var Tf=class{static{this.prototype.isMatrix2=!0}constructor(e,n,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,n,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,n=0){for(let i=0;i<4;i++)this.elements[i]=e[i+n];return this}set(e,n,i,s){let r=this.elements;return r[0]=e,r[2]=n,r[1]=i,r[3]=s,this}};var Va=class extends Vi{constructor(e,n=null){super(),this.object=e,this.domElement=n,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function nd(t,e,n,i){let s=eb(i);switch(n){case Xf:return t*e;case Xa:return t*e/s.components*s.byteLength;case nu:return t*e/s.components*s.byteLength;case Zi:return t*e*2/s.components*s.byteLength;case iu:return t*e*2/s.components*s.byteLength;case qf:return t*e*3/s.components*s.byteLength;case ci:return t*e*4/s.components*s.byteLength;case su:return t*e*4/s.components*s.byteLength;case qa:case $a:return Math.floor((t+3)/4)*Math.floor((e+3)/4)*8;case Ya:case Za:return Math.floor((t+3)/4)*Math.floor((e+3)/4)*16;case ou:case lu:return Math.max(t,16)*Math.max(e,8)/4;case ru:case au:return Math.max(t,8)*Math.max(e,8)/2;case cu:case uu:case fu:case du:return Math.floor((t+3)/4)*Math.floor((e+3)/4)*8;case hu:case ja:case pu:return Math.floor((t+3)/4)*Math.floor((e+3)/4)*16;case mu:return Math.floor((t+3)/4)*Math.floor((e+3)/4)*16;case gu:return Math.floor((t+4)/5)*Math.floor((e+3)/4)*16;case _u:return Math.floor((t+4)/5)*Math.floor((e+4)/5)*16;case xu:return Math.floor((t+5)/6)*Math.floor((e+4)/5)*16;case vu:return Math.floor((t+5)/6)*Math.floor((e+5)/6)*16;case yu:return Math.floor((t+7)/8)*Math.floor((e+4)/5)*16;case Su:return Math.floor((t+7)/8)*Math.floor((e+5)/6)*16;case Mu:return Math.floor((t+7)/8)*Math.floor((e+7)/8)*16;case bu:return Math.floor((t+9)/10)*Math.floor((e+4)/5)*16;case wu:return Math.floor((t+9)/10)*Math.floor((e+5)/6)*16;case Eu:return Math.floor((t+9)/10)*Math.floor((e+7)/8)*16;case Au:return Math.floor((t+9)/10)*Math.floor((e+9)/10)*16;case Tu:return Math.floor((t+11)/12)*Math.floor((e+9)/10)*16;case Cu:return Math.floor((t+11)/12)*Math.floor((e+11)/12)*16;case Ru:case Pu:case Iu:return Math.ceil(t/4)*Math.ceil(e/4)*16;case Lu:case Nu:return Math.ceil(t/4)*Math.ceil(e/4)*8;case Ja:case Du:return Math.ceil(t/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${n} format.`)}function eb(t){switch(t){case $n:case Gf:return{byteLength:1,components:1};case Lo:case Vf:case Yi:return{byteLength:2,components:1};case eu:case tu:return{byteLength:2,components:4};case qi:case Qc:case $i:return{byteLength:4,components:1};case Hf:case Wf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${t}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Je("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function r0(){let t=null,e=!1,n=null,i=null;function s(r,o){i=t.requestAnimationFrame(s),n(r,o)}return{start:function(){e!==!0&&n!==null&&t!==null&&(i=t.requestAnimationFrame(s),e=!0)},stop:function(){t!==null&&t.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){n=r},setContext:function(r){t=r}}}function nb(t){let e=new WeakMap;function n(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=t.createBuffer();t.bindBuffer(l,f),t.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=t.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=t.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=t.HALF_FLOAT:d=t.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=t.SHORT;else if(c instanceof Uint32Array)d=t.UNSIGNED_INT;else if(c instanceof Int32Array)d=t.INT;else if(c instanceof Int8Array)d=t.BYTE;else if(c instanceof Uint8Array)d=t.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=t.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(t.bindBuffer(c,a),h.length===0)t.bufferSubData(c,0,u);else{h.sort((d,g)=>d.start-g.start);let f=0;for(let d=1;d<h.length;d++){let g=h[f],y=h[d];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++f,h[f]=y)}h.length=f+1;for(let d=0,g=h.length;d<g;d++){let y=h[d];t.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(t.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,n(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var ib=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,sb=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,rb=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,ob=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,ab=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,lb=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,cb=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,ub=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,hb=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,fb=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,db=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,pb=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,mb=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,gb=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,_b=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,xb=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,vb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,yb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Sb=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Mb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,bb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,wb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Eb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Ab=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Tb=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Cb=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Rb=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Pb=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Ib=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Lb="gl_FragColor = linearToOutputTexel( gl_FragColor );",Nb=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Db=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Ub=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Fb=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Ob=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Bb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,kb=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,zb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Gb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Vb=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Hb=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Wb=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Xb=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,qb=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,$b=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Yb=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Zb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,jb=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Jb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Kb=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Qb=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,ew=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,tw=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,nw=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,iw=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,sw=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,rw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,ow=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,aw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,lw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,cw=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,uw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,hw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,fw=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,dw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,pw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,mw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,gw=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,_w=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,xw=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,vw=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,yw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Sw=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Mw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,bw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,ww=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Ew=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Aw=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Tw=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Cw=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Rw=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Pw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Iw=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Lw=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Nw=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Dw=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Uw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Fw=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Ow=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Bw=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,kw=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,zw=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Gw=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Vw=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Hw=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Ww=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Xw=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,qw=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,$w=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Yw=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Zw=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,jw=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Jw=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Kw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Qw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,e1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,t1=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,n1=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,i1=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,s1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,r1=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,o1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,a1=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,l1=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,c1=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,u1=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,h1=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,f1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,d1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,p1=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,m1=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,g1=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,_1=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,x1=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,v1=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,y1=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,S1=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,M1=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,b1=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,w1=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,E1=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,A1=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,T1=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,C1=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,R1=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,P1=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,I1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,L1=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,N1=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,D1=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,U1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ft={alphahash_fragment:ib,alphahash_pars_fragment:sb,alphamap_fragment:rb,alphamap_pars_fragment:ob,alphatest_fragment:ab,alphatest_pars_fragment:lb,aomap_fragment:cb,aomap_pars_fragment:ub,batching_pars_vertex:hb,batching_vertex:fb,begin_vertex:db,beginnormal_vertex:pb,bsdfs:mb,iridescence_fragment:gb,bumpmap_pars_fragment:_b,clipping_planes_fragment:xb,clipping_planes_pars_fragment:vb,clipping_planes_pars_vertex:yb,clipping_planes_vertex:Sb,color_fragment:Mb,color_pars_fragment:bb,color_pars_vertex:wb,color_vertex:Eb,common:Ab,defaultnormal_vertex:Tb,displacementmap_pars_vertex:Cb,displacementmap_vertex:Rb,emissivemap_fragment:Pb,emissivemap_pars_fragment:Ib,colorspace_fragment:Lb,colorspace_pars_fragment:Nb,envmap_fragment:Db,envmap_common_pars_fragment:Ub,envmap_pars_fragment:Fb,envmap_pars_vertex:Ob,envmap_physical_pars_fragment:Yb,envmap_vertex:Bb,fog_vertex:kb,fog_pars_vertex:zb,fog_fragment:Gb,fog_pars_fragment:Vb,gradientmap_pars_fragment:Hb,lightmap_pars_fragment:Wb,lights_lambert_fragment:Xb,lights_lambert_pars_fragment:qb,lights_pars_begin:$b,lights_toon_fragment:Zb,lights_toon_pars_fragment:jb,lights_phong_fragment:Jb,lights_phong_pars_fragment:Kb,lights_physical_fragment:Qb,lights_physical_pars_fragment:ew,lights_fragment_begin:tw,lights_fragment_maps:nw,lights_fragment_end:iw,lightprobes_pars_fragment:sw,logdepthbuf_fragment:rw,logdepthbuf_pars_fragment:ow,logdepthbuf_pars_vertex:aw,logdepthbuf_vertex:lw,map_fragment:cw,map_pars_fragment:uw,map_particle_fragment:hw,map_particle_pars_fragment:fw,metalnessmap_fragment:dw,metalnessmap_pars_fragment:pw,morphinstance_vertex:mw,morphcolor_vertex:gw,morphnormal_vertex:_w,morphtarget_pars_vertex:xw,morphtarget_vertex:vw,normal_fragment_begin:yw,normal_fragment_maps:Sw,normal_pars_fragment:Mw,normal_pars_vertex:bw,normal_vertex:ww,normalmap_pars_fragment:Ew,clearcoat_normal_fragment_begin:Aw,clearcoat_normal_fragment_maps:Tw,clearcoat_pars_fragment:Cw,iridescence_pars_fragment:Rw,opaque_fragment:Pw,packing:Iw,premultiplied_alpha_fragment:Lw,project_vertex:Nw,dithering_fragment:Dw,dithering_pars_fragment:Uw,roughnessmap_fragment:Fw,roughnessmap_pars_fragment:Ow,shadowmap_pars_fragment:Bw,shadowmap_pars_vertex:kw,shadowmap_vertex:zw,shadowmask_pars_fragment:Gw,skinbase_vertex:Vw,skinning_pars_vertex:Hw,skinning_vertex:Ww,skinnormal_vertex:Xw,specularmap_fragment:qw,specularmap_pars_fragment:$w,tonemapping_fragment:Yw,tonemapping_pars_fragment:Zw,transmission_fragment:jw,transmission_pars_fragment:Jw,uv_pars_fragment:Kw,uv_pars_vertex:Qw,uv_vertex:e1,worldpos_vertex:t1,background_vert:n1,background_frag:i1,backgroundCube_vert:s1,backgroundCube_frag:r1,cube_vert:o1,cube_frag:a1,depth_vert:l1,depth_frag:c1,distance_vert:u1,distance_frag:h1,equirect_vert:f1,equirect_frag:d1,linedashed_vert:p1,linedashed_frag:m1,meshbasic_vert:g1,meshbasic_frag:_1,meshlambert_vert:x1,meshlambert_frag:v1,meshmatcap_vert:y1,meshmatcap_frag:S1,meshnormal_vert:M1,meshnormal_frag:b1,meshphong_vert:w1,meshphong_frag:E1,meshphysical_vert:A1,meshphysical_frag:T1,meshtoon_vert:C1,meshtoon_frag:R1,points_vert:P1,points_frag:I1,shadow_vert:L1,shadow_frag:N1,sprite_vert:D1,sprite_frag:U1},De={common:{diffuse:{value:new $e(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new st}},envmap:{envMap:{value:null},envMapRotation:{value:new st},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new st}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new st}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new st},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new st},normalScale:{value:new it(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new st},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new st}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new st}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new st}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new $e(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new $e(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0},uvTransform:{value:new st}},sprite:{diffuse:{value:new $e(16777215)},opacity:{value:1},center:{value:new it(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}}},ds={basic:{uniforms:Yn([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.fog]),vertexShader:ft.meshbasic_vert,fragmentShader:ft.meshbasic_frag},lambert:{uniforms:Yn([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new $e(0)},envMapIntensity:{value:1}}]),vertexShader:ft.meshlambert_vert,fragmentShader:ft.meshlambert_frag},phong:{uniforms:Yn([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new $e(0)},specular:{value:new $e(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ft.meshphong_vert,fragmentShader:ft.meshphong_frag},standard:{uniforms:Yn([De.common,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.roughnessmap,De.metalnessmap,De.fog,De.lights,{emissive:{value:new $e(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag},toon:{uniforms:Yn([De.common,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.gradientmap,De.fog,De.lights,{emissive:{value:new $e(0)}}]),vertexShader:ft.meshtoon_vert,fragmentShader:ft.meshtoon_frag},matcap:{uniforms:Yn([De.common,De.bumpmap,De.normalmap,De.displacementmap,De.fog,{matcap:{value:null}}]),vertexShader:ft.meshmatcap_vert,fragmentShader:ft.meshmatcap_frag},points:{uniforms:Yn([De.points,De.fog]),vertexShader:ft.points_vert,fragmentShader:ft.points_frag},dashed:{uniforms:Yn([De.common,De.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ft.linedashed_vert,fragmentShader:ft.linedashed_frag},depth:{uniforms:Yn([De.common,De.displacementmap]),vertexShader:ft.depth_vert,fragmentShader:ft.depth_frag},normal:{uniforms:Yn([De.common,De.bumpmap,De.normalmap,De.displacementmap,{opacity:{value:1}}]),vertexShader:ft.meshnormal_vert,fragmentShader:ft.meshnormal_frag},sprite:{uniforms:Yn([De.sprite,De.fog]),vertexShader:ft.sprite_vert,fragmentShader:ft.sprite_frag},background:{uniforms:{uvTransform:{value:new st},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ft.background_vert,fragmentShader:ft.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new st}},vertexShader:ft.backgroundCube_vert,fragmentShader:ft.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ft.cube_vert,fragmentShader:ft.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ft.equirect_vert,fragmentShader:ft.equirect_frag},distance:{uniforms:Yn([De.common,De.displacementmap,{referencePosition:{value:new F},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ft.distance_vert,fragmentShader:ft.distance_frag},shadow:{uniforms:Yn([De.lights,De.fog,{color:{value:new $e(0)},opacity:{value:1}}]),vertexShader:ft.shadow_vert,fragmentShader:ft.shadow_frag}};ds.physical={uniforms:Yn([ds.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new st},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new st},clearcoatNormalScale:{value:new it(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new st},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new st},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new st},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new st},sheen:{value:0},sheenColor:{value:new $e(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new st},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new st},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new st},transmissionSamplerSize:{value:new it},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new st},attenuationDistance:{value:0},attenuationColor:{value:new $e(0)},specularColor:{value:new $e(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new st},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new st},anisotropyVector:{value:new it},anisotropyMap:{value:null},anisotropyMapTransform:{value:new st}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag};var Uu={r:0,b:0,g:0},F1=new Dt,o0=new st;o0.set(-1,0,0,0,1,0,0,0,1);function O1(t,e,n,i,s,r){let o=new $e(0),a=s===!0?0:1,l,c,u=null,h=0,f=null;function d(v){let T=v.isScene===!0?v.background:null;if(T&&T.isTexture){let S=v.backgroundBlurriness>0;T=e.get(T,S)}return T}function g(v){let T=!1,S=d(v);S===null?p(o,a):S&&S.isColor&&(p(S,1),T=!0);let C=t.xr.getEnvironmentBlendMode();C==="additive"?n.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,r),(t.autoClear||T)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),t.clear(t.autoClearColor,t.autoClearDepth,t.autoClearStencil))}function y(v,T){let S=d(T);S&&S.isCubeTexture?(c===void 0&&(c=new Me(new hn(1,1,1),new Vn({name:"BackgroundCubeMaterial",uniforms:Rr(ds.backgroundCube.uniforms),vertexShader:ds.backgroundCube.vertexShader,fragmentShader:ds.backgroundCube.fragmentShader,side:ri,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,A,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(F1.makeRotationFromEuler(T.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(o0),c.material.toneMapped=xt.getTransfer(S.colorSpace)!==Rt,(u!==S||h!==S.version||f!==t.toneMapping)&&(c.material.needsUpdate=!0,u=S,h=S.version,f=t.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Me(new Ls(2,2),new Vn({name:"BackgroundMaterial",uniforms:Rr(ds.background.uniforms),vertexShader:ds.background.vertexShader,fragmentShader:ds.background.fragmentShader,side:lr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=xt.getTransfer(S.colorSpace)!==Rt,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||h!==S.version||f!==t.toneMapping)&&(l.material.needsUpdate=!0,u=S,h=S.version,f=t.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function p(v,T){v.getRGB(Uu,Qf(t)),n.buffers.color.setClear(Uu.r,Uu.g,Uu.b,T,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,T=1){o.set(v),a=T,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,p(o,a)},render:g,addToRenderList:y,dispose:m}}function B1(t,e){let n=t.getParameter(t.MAX_VERTEX_ATTRIBS),i={},s=f(null),r=s,o=!1;function a(N,k,H,I,z){let $=!1,V=h(N,I,H,k);r!==V&&(r=V,c(r.object)),$=d(N,I,H,z),$&&g(N,I,H,z),z!==null&&e.update(z,t.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,S(N,k,H,I),z!==null&&t.bindBuffer(t.ELEMENT_ARRAY_BUFFER,e.get(z).buffer))}function l(){return t.createVertexArray()}function c(N){return t.bindVertexArray(N)}function u(N){return t.deleteVertexArray(N)}function h(N,k,H,I){let z=I.wireframe===!0,$=i[k.id];$===void 0&&($={},i[k.id]=$);let V=N.isInstancedMesh===!0?N.id:0,ae=$[V];ae===void 0&&(ae={},$[V]=ae);let q=ae[H.id];q===void 0&&(q={},ae[H.id]=q);let K=q[z];return K===void 0&&(K=f(l()),q[z]=K),K}function f(N){let k=[],H=[],I=[];for(let z=0;z<n;z++)k[z]=0,H[z]=0,I[z]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:H,attributeDivisors:I,object:N,attributes:{},index:null}}function d(N,k,H,I){let z=r.attributes,$=k.attributes,V=0,ae=H.getAttributes();for(let q in ae)if(ae[q].location>=0){let ne=z[q],he=$[q];if(he===void 0&&(q==="instanceMatrix"&&N.instanceMatrix&&(he=N.instanceMatrix),q==="instanceColor"&&N.instanceColor&&(he=N.instanceColor)),ne===void 0||ne.attribute!==he||he&&ne.data!==he.data)return!0;V++}return r.attributesNum!==V||r.index!==I}function g(N,k,H,I){let z={},$=k.attributes,V=0,ae=H.getAttributes();for(let q in ae)if(ae[q].location>=0){let ne=$[q];ne===void 0&&(q==="instanceMatrix"&&N.instanceMatrix&&(ne=N.instanceMatrix),q==="instanceColor"&&N.instanceColor&&(ne=N.instanceColor));let he={};he.attribute=ne,ne&&ne.data&&(he.data=ne.data),z[q]=he,V++}r.attributes=z,r.attributesNum=V,r.index=I}function y(){let N=r.newAttributes;for(let k=0,H=N.length;k<H;k++)N[k]=0}function p(N){m(N,0)}function m(N,k){let H=r.newAttributes,I=r.enabledAttributes,z=r.attributeDivisors;H[N]=1,I[N]===0&&(t.enableVertexAttribArray(N),I[N]=1),z[N]!==k&&(t.vertexAttribDivisor(N,k),z[N]=k)}function v(){let N=r.newAttributes,k=r.enabledAttributes;for(let H=0,I=k.length;H<I;H++)k[H]!==N[H]&&(t.disableVertexAttribArray(H),k[H]=0)}function T(N,k,H,I,z,$,V){V===!0?t.vertexAttribIPointer(N,k,H,z,$):t.vertexAttribPointer(N,k,H,I,z,$)}function S(N,k,H,I){y();let z=I.attributes,$=H.getAttributes(),V=k.defaultAttributeValues;for(let ae in $){let q=$[ae];if(q.location>=0){let K=z[ae];if(K===void 0&&(ae==="instanceMatrix"&&N.instanceMatrix&&(K=N.instanceMatrix),ae==="instanceColor"&&N.instanceColor&&(K=N.instanceColor)),K!==void 0){let ne=K.normalized,he=K.itemSize,fe=e.get(K);if(fe===void 0)continue;let Q=fe.buffer,me=fe.type,xe=fe.bytesPerElement,Re=me===t.INT||me===t.UNSIGNED_INT||K.gpuType===Qc;if(K.isInterleavedBufferAttribute){let we=K.data,Xe=we.isInterleavedBuffer===!0?we.stride:we.itemSize,at=K.offset;if(we.isInstancedInterleavedBuffer||we.isInstancedBufferAttribute){for(let He=0;He<q.locationSize;He++)m(q.location+He,we.meshPerAttribute);N.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=we.meshPerAttribute*we.count)}else for(let He=0;He<q.locationSize;He++)p(q.location+He);t.bindBuffer(t.ARRAY_BUFFER,Q);for(let He=0;He<q.locationSize;He++)T(q.location+He,he/q.locationSize,me,ne,Xe*xe,(at+he/q.locationSize*He)*xe,Re)}else{if(K.isInstancedBufferAttribute){for(let we=0;we<q.locationSize;we++)m(q.location+we,K.meshPerAttribute);N.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=K.meshPerAttribute*K.count)}else for(let we=0;we<q.locationSize;we++)p(q.location+we);t.bindBuffer(t.ARRAY_BUFFER,Q);for(let we=0;we<q.locationSize;we++)T(q.location+we,he/q.locationSize,me,ne,he*xe,he/q.locationSize*we*xe,Re)}}else if(V!==void 0){let ne=V[ae];if(ne!==void 0)switch(ne.length){case 2:t.vertexAttrib2fv(q.location,ne);break;case 3:t.vertexAttrib3fv(q.location,ne);break;case 4:t.vertexAttrib4fv(q.location,ne);break;default:t.vertexAttrib1fv(q.location,ne)}}}}v()}function C(){U();for(let N in i){let k=i[N];for(let H in k){let I=k[H];for(let z in I){let $=I[z];for(let V in $)u($[V].object),delete $[V];delete I[z]}}delete i[N]}}function A(N){if(i[N.id]===void 0)return;let k=i[N.id];for(let H in k){let I=k[H];for(let z in I){let $=I[z];for(let V in $)u($[V].object),delete $[V];delete I[z]}}delete i[N.id]}function _(N){for(let k in i){let H=i[k];for(let I in H){let z=H[I];if(z[N.id]===void 0)continue;let $=z[N.id];for(let V in $)u($[V].object),delete $[V];delete z[N.id]}}}function w(N){for(let k in i){let H=i[k],I=N.isInstancedMesh===!0?N.id:0,z=H[I];if(z!==void 0){for(let $ in z){let V=z[$];for(let ae in V)u(V[ae].object),delete V[ae];delete z[$]}delete H[I],Object.keys(H).length===0&&delete i[k]}}}function U(){L(),o=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:L,dispose:C,releaseStatesOfGeometry:A,releaseStatesOfObject:w,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:p,disableUnusedAttributes:v}}function k1(t,e,n){let i;function s(l){i=l}function r(l,c){t.drawArrays(i,l,c),n.update(c,i,1)}function o(l,c,u){u!==0&&(t.drawArraysInstanced(i,l,c,u),n.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let f=0;for(let d=0;d<u;d++)f+=c[d];n.update(f,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function z1(t,e,n,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let _=e.get("EXT_texture_filter_anisotropic");s=t.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==ci&&i.convert(_)!==t.getParameter(t.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let w=_===Yi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(_!==$n&&_!==$i&&!w&&i.convert(_)!==t.getParameter(t.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(t.getShaderPrecisionFormat(t.VERTEX_SHADER,t.HIGH_FLOAT).precision>0&&t.getShaderPrecisionFormat(t.FRAGMENT_SHADER,t.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&t.getShaderPrecisionFormat(t.VERTEX_SHADER,t.MEDIUM_FLOAT).precision>0&&t.getShaderPrecisionFormat(t.FRAGMENT_SHADER,t.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=n.precision!==void 0?n.precision:"highp",u=l(c);u!==c&&(Je("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=n.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=n.logarithmicDepthBuffer===!0&&h===!1;n.reversedDepthBuffer===!0&&h===!1&&Je("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),n.logarithmicDepthBuffer===!0&&h===!0&&Je("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=t.getParameter(t.MAX_TEXTURE_IMAGE_UNITS),g=t.getParameter(t.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=t.getParameter(t.MAX_TEXTURE_SIZE),p=t.getParameter(t.MAX_CUBE_MAP_TEXTURE_SIZE),m=t.getParameter(t.MAX_VERTEX_ATTRIBS),v=t.getParameter(t.MAX_VERTEX_UNIFORM_VECTORS),T=t.getParameter(t.MAX_VARYING_VECTORS),S=t.getParameter(t.MAX_FRAGMENT_UNIFORM_VECTORS),C=t.getParameter(t.MAX_SAMPLES),A=t.getParameter(t.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:d,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:v,maxVaryings:T,maxFragmentUniforms:S,maxSamples:C,samples:A}}function G1(t){let e=this,n=null,i=0,s=!1,r=!1,o=new Gi,a=new st,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let d=h.length!==0||f||i!==0||s;return s=f,i=h.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){n=u(h,f,0)},this.setState=function(h,f,d){let g=h.clippingPlanes,y=h.clipIntersection,p=h.clipShadows,m=t.get(h);if(!s||g===null||g.length===0||r&&!p)r?u(null):c();else{let v=r?0:i,T=v*4,S=m.clippingState||null;l.value=S,S=u(g,f,T,d);for(let C=0;C!==T;++C)S[C]=n[C];m.clippingState=S,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==n&&(l.value=n,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,f,d,g){let y=h!==null?h.length:0,p=null;if(y!==0){if(p=l.value,g!==!0||p===null){let m=d+y*4,v=f.matrixWorldInverse;a.getNormalMatrix(v),(p===null||p.length<m)&&(p=new Float32Array(m));for(let T=0,S=d;T!==y;++T,S+=4)o.copy(h[T]).applyMatrix4(v,a),o.normal.toArray(p,S),p[S+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,p}}var il=class extends gi{constructor(e=1,n={}){super(e,e,n),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Pa(s),this._setTextureOptions(n),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,n){this.texture.type=n.type,this.texture.colorSpace=n.colorSpace,this.texture.generateMipmaps=n.generateMipmaps,this.texture.minFilter=n.minFilter,this.texture.magFilter=n.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new hn(5,5,5),r=new Vn({name:"CubemapFromEquirect",uniforms:Rr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ri,blending:Ds});r.uniforms.tEquirect.value=n;let o=new Me(s,r),a=n.minFilter;return n.minFilter===Us&&(n.minFilter=si),new Co(1,10,this).update(e,o),n.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,n=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(n,i,s);e.setRenderTarget(r)}},Bg=256,V1=3,H1=20,a0=256,l0=16,W1=3,X1=new F,q1=new $e,Ou=class t{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Co(1,10,null),this._boxMesh=new Me(new hn(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,n=0,i=.1,s=100,r={}){let{size:o=256,position:a=X1}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);n>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,g=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(q1));let p=new Co(i,s,u);return p.position.copy(a),p.update(l,e),l.autoClear=h,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=g,e.background=y,n>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,n)),this._applyPMREM(c),c}fromEquirectangular(e,n=null){return this._fromTexture(e,n)}fromCubemap(e,n=null){return this._fromTexture(e,n)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Gg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=zg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,n){return n>0?1-Math.sqrt(1-e/n):0}_setSize(e){this._cubeSize=Math.max(Bg,Ng(e))}_fromTexture(e,n){e.mapping===Tr||e.mapping===Io?this._setSize(e.image.length===0?Bg:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=n||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,n=kg(e,!1,!1),i=Math.log2(e)-V1;for(let s=0;s<=i;s++)n.texture.mipmaps.push({width:e>>s,height:e>>s});return n.texture.name="PMREM",n.texture.isPMREMTexture=!0,n}_getSourceTarget(e=!1){let n=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==n||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=kg(n,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,n,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=n;let o=e.width>>n;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let n;e.mapping===Tr||e.mapping===Io?(this._cubemapMaterial===null&&(this._cubemapMaterial=Gg()),n=this._cubemapMaterial,n.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=zg()),n=this._equirectMaterial),n.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,n)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=$1(),this._integrationMaterial=Y1());let n=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(n/l0);for(let o=0;o<=i;o++){let a=t.lodToRoughness(o,i);if(o>i-W1)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(n)+.5*Math.log2(6/(a0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,n){this._blurMaterial===null&&(this._blurMaterial=Z1());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(n,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function kg(t,e,n){return new il(t,{minFilter:Us,generateMipmaps:e,type:Yi,colorSpace:Ma,depthBuffer:n})}function sl(t,e,n){return new Vn({name:t,uniforms:e,vertexShader:ft.cube_vert,fragmentShader:n,side:ri,blending:Ds,depthTest:!1,depthWrite:!1})}function $1(){return sl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${a0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Y1(){return sl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:l0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Z1(){return sl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${H1}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function zg(){return sl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Gg(){return sl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function j1(t){let e=new WeakMap,n=new WeakMap,i=null;function s(f,d=!1){return f==null?null:d?o(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===jc||d===Jc)if(e.has(f)){let g=e.get(f).texture;return a(g,f.mapping)}else{let g=f.image;if(g&&g.height>0){let y=new il(g.height);return y.fromEquirectangularTexture(t,f),e.set(f,y),f.addEventListener("dispose",c),a(y.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,g=d===jc||d===Jc,y=d===Tr||d===Io;if(g||y){let p=n.get(f),m=p!==void 0?p.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==m)return i===null&&(i=new Ou(t)),p=g?i.fromEquirectangular(f,p):i.fromCubemap(f,p),p.texture.pmremVersion=f.pmremVersion,n.set(f,p),p.texture;if(p!==void 0)return p.texture;{let v=f.image;return g&&v&&v.height>0||y&&v&&l(v)?(i===null&&(i=new Ou(t)),p=g?i.fromEquirectangular(f):i.fromCubemap(f),p.texture.pmremVersion=f.pmremVersion,n.set(f,p),f.addEventListener("dispose",u),p.texture):null}}}return f}function a(f,d){return d===jc?f.mapping=Tr:d===Jc&&(f.mapping=Io),f}function l(f){let d=0,g=6;for(let y=0;y<g;y++)f[y]!==void 0&&d++;return d===g}function c(f){let d=f.target;d.removeEventListener("dispose",c);let g=e.get(d);g!==void 0&&(e.delete(d),g.dispose())}function u(f){let d=f.target;d.removeEventListener("dispose",u);let g=n.get(d);g!==void 0&&(n.delete(d),g.dispose())}function h(){e=new WeakMap,n=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function J1(t){let e={};function n(i){if(e[i]!==void 0)return e[i];let s=t.getExtension(i);return e[i]=s,s}return{has:function(i){return n(i)!==null},init:function(){n("EXT_color_buffer_float"),n("WEBGL_clip_cull_distance"),n("OES_texture_float_linear"),n("EXT_color_buffer_half_float"),n("WEBGL_multisampled_render_to_texture"),n("WEBGL_render_shared_exponent")},get:function(i){let s=n(i);return s===null&&ya("WebGLRenderer: "+i+" extension not supported."),s}}}function K1(t,e,n,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let p in g.attributes)e.remove(g.attributes[p]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let y=r.get(g);y&&(e.remove(y),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,n.memory.geometries--}function c(g,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),n.memory.geometries++),y}function u(g){let y=g.attributes;for(let p in y)e.update(y[p],t.ARRAY_BUFFER)}function h(g){let y=g.index,p=g.attributes.position,m=0;if(p===void 0)return;let v=y!==null?y.array.length:p.array.length/3-1,T=p.count>=65535?Ca:Ta,S=new T(Math.ceil(v/3)*6,1),C=S.array;if(y!==null){let _=y.array;m=y.version;for(let w=0,U=0;w<v;w+=3){let L=_[w+0],N=_[w+1],k=_[w+2];C[U++]=L,C[U++]=N,C[U++]=N,C[U++]=k,C[U++]=k,C[U++]=L}}else{m=p.version;for(let _=0,w=0;_<v;_+=3){let U=_+0,L=_+1,N=_+2;C[w++]=U,C[w++]=L,C[w++]=L,C[w++]=N,C[w++]=N,C[w++]=U}}S.version=m;let A=r.get(g);A&&e.remove(A),r.set(g,S)}function f(g){let y=r.get(g);if(y){let p=g.index;p!==null&&y.version<p.version&&h(g)}else h(g);return r.get(g)}function d(){for(let g in s){let y=s[g].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:f,dispose:d}}function Q1(t,e,n){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,f){t.drawElements(i,f,r,h*o),n.update(f,i,1)}function c(h,f,d){d!==0&&(t.drawElementsInstanced(i,f,r,h*o,d),n.update(f,i,d))}function u(h,f,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,r,h,0,d);let y=0;for(let p=0;p<d;p++)y+=f[p];n.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function eE(t){let e={geometries:0,textures:0},n={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(n.calls++,o){case t.TRIANGLES:n.triangles+=a*(r/3);break;case t.LINES:n.lines+=a*(r/2);break;case t.LINE_STRIP:n.lines+=a*(r-1);break;case t.LINE_LOOP:n.lines+=a*r;break;case t.POINTS:n.points+=a*r;break;default:tt("WebGLInfo: Unknown draw mode:",o);break}}function s(){n.calls=0,n.triangles=0,n.points=0,n.lines=0}return{memory:e,render:n,programs:null,autoReset:!0,reset:s,update:i}}function tE(t,e,n){let i=new WeakMap,s=new Ht;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=i.get(a);if(f===void 0||f.count!==h){let U=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",U)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],T=0;d===!0&&(T=1),g===!0&&(T=2),y===!0&&(T=3);let S=a.attributes.position.count*T,C=1;S>e.maxTextureSize&&(C=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let A=new Float32Array(S*C*4*h),_=new Ea(A,S,C,h);_.type=$i,_.needsUpdate=!0;let w=T*4;for(let L=0;L<h;L++){let N=p[L],k=m[L],H=v[L],I=S*C*4*L;for(let z=0;z<N.count;z++){let $=z*w;d===!0&&(s.fromBufferAttribute(N,z),A[I+$+0]=s.x,A[I+$+1]=s.y,A[I+$+2]=s.z,A[I+$+3]=0),g===!0&&(s.fromBufferAttribute(k,z),A[I+$+4]=s.x,A[I+$+5]=s.y,A[I+$+6]=s.z,A[I+$+7]=0),y===!0&&(s.fromBufferAttribute(H,z),A[I+$+8]=s.x,A[I+$+9]=s.y,A[I+$+10]=s.z,A[I+$+11]=H.itemSize===4?s.w:1)}}f={count:h,texture:_,size:new it(S,C)},i.set(a,f),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(t,"morphTexture",o.morphTexture,n);else{let d=0;for(let y=0;y<c.length;y++)d+=c[y];let g=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(t,"morphTargetBaseInfluence",g),l.getUniforms().setValue(t,"morphTargetInfluences",c)}l.getUniforms().setValue(t,"morphTargetsTexture",f.texture,n),l.getUniforms().setValue(t,"morphTargetsTextureSize",f.size)}return{update:r}}function nE(t,e,n,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,f=e.get(c,h);if(r.get(f)!==u&&(e.update(f),r.set(f,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(n.update(c.instanceMatrix,t.ARRAY_BUFFER),c.instanceColor!==null&&n.update(c.instanceColor,t.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return f}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),n.remove(u.instanceMatrix),u.instanceColor!==null&&n.remove(u.instanceColor)}return{update:o,dispose:a}}var iE={[Df]:"LINEAR_TONE_MAPPING",[Uf]:"REINHARD_TONE_MAPPING",[Ff]:"CINEON_TONE_MAPPING",[Of]:"ACES_FILMIC_TONE_MAPPING",[kf]:"AGX_TONE_MAPPING",[Ha]:"NEUTRAL_TONE_MAPPING",[Bf]:"CUSTOM_TONE_MAPPING"};function sE(t,e,n,i,s,r){let o=new gi(e,n,{type:t,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new jt;u.setAttribute("position",new wt([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new wt([0,2,0,0,2,0],2));let h=new Dc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new Me(u,h),d=new za(-1,1,1,-1,0,1),g=null,y=null,p=!1,m,v=null,T=[],S=!1;this.setSize=function(C,A){o.setSize(C,A),a!==null&&a.setSize(C,A),l!==null&&l.setSize(C,A);for(let _=0;_<T.length;_++){let w=T[_];w.setSize&&w.setSize(C,A)}},this.setEffects=function(C){T=C,S=T.length>0&&T[0].isRenderPass===!0;let A=o.width,_=o.height;T.length>0&&a===null&&(a=new gi(A,_,{type:Yi,depthBuffer:!1,stencilBuffer:!1}),l=new gi(A,_,{type:Yi,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&T.some(U=>U.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new Ps(A,_),r===!0&&(c.format=Fs,c.type=Cr)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let U=0;U<T.length;U++){let L=T[U];L.setSize&&L.setSize(A,_),w&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(C,A){if(p||C.toneMapping===hs&&T.length===0)return!1;if(v=A,A!==null){let _=A.width,w=A.height;(o.width!==_||o.height!==w)&&this.setSize(_,w)}return S===!1&&C.setRenderTarget(o),m=C.toneMapping,C.toneMapping=hs,!0},this.hasRenderPass=function(){return S},this.end=function(C,A){C.toneMapping=m,p=!0;let _=o,w=a;for(let U=0;U<T.length;U++){let L=T[U];L.enabled!==!1&&(L.render(C,w,_,A),L.needsSwap!==!1&&(_=w,w=w===a?l:a))}if(g!==C.outputColorSpace||y!==C.toneMapping){g=C.outputColorSpace,y=C.toneMapping,h.defines={},xt.getTransfer(g)===Rt&&(h.defines.SRGB_TRANSFER="");let U=iE[y];U&&(h.defines[U]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=_.texture,C.setRenderTarget(v),C.render(f,d),v=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var c0=new li,u0=new Ps(1,1),h0=new Ia(1),f0=new Ea,d0=new Rc,p0=new Pa,Vg=[],Hg=[],Wg=new Float32Array(16),Xg=new Float32Array(9),qg=new Float32Array(4);function Do(t,e,n){let i=t[0];if(i<=0||i>0)return t;let s=e*n,r=Vg[s];if(r===void 0&&(r=new Float32Array(s),Vg[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=n,t[o].toArray(r,a)}return r}function Tn(t,e){if(t.length!==e.length)return!1;for(let n=0,i=t.length;n<i;n++)if(t[n]!==e[n])return!1;return!0}function Cn(t,e){for(let n=0,i=e.length;n<i;n++)t[n]=e[n]}function ku(t,e){let n=Hg[e];n===void 0&&(n=new Int32Array(e),Hg[e]=n);for(let i=0;i!==e;++i)n[i]=t.allocateTextureUnit();return n}function rE(t,e){let n=this.cache;n[0]!==e&&(t.uniform1f(this.addr,e),n[0]=e)}function oE(t,e){let n=this.cache;if(e.x!==void 0)(n[0]!==e.x||n[1]!==e.y)&&(t.uniform2f(this.addr,e.x,e.y),n[0]=e.x,n[1]=e.y);else{if(Tn(n,e))return;t.uniform2fv(this.addr,e),Cn(n,e)}}function aE(t,e){let n=this.cache;if(e.x!==void 0)(n[0]!==e.x||n[1]!==e.y||n[2]!==e.z)&&(t.uniform3f(this.addr,e.x,e.y,e.z),n[0]=e.x,n[1]=e.y,n[2]=e.z);else if(e.r!==void 0)(n[0]!==e.r||n[1]!==e.g||n[2]!==e.b)&&(t.uniform3f(this.addr,e.r,e.g,e.b),n[0]=e.r,n[1]=e.g,n[2]=e.b);else{if(Tn(n,e))return;t.uniform3fv(this.addr,e),Cn(n,e)}}function lE(t,e){let n=this.cache;if(e.x!==void 0)(n[0]!==e.x||n[1]!==e.y||n[2]!==e.z||n[3]!==e.w)&&(t.uniform4f(this.addr,e.x,e.y,e.z,e.w),n[0]=e.x,n[1]=e.y,n[2]=e.z,n[3]=e.w);else{if(Tn(n,e))return;t.uniform4fv(this.addr,e),Cn(n,e)}}function cE(t,e){let n=this.cache,i=e.elements;if(i===void 0){if(Tn(n,e))return;t.uniformMatrix2fv(this.addr,!1,e),Cn(n,e)}else{if(Tn(n,i))return;qg.set(i),t.uniformMatrix2fv(this.addr,!1,qg),Cn(n,i)}}function uE(t,e){let n=this.cache,i=e.elements;if(i===void 0){if(Tn(n,e))return;t.uniformMatrix3fv(this.addr,!1,e),Cn(n,e)}else{if(Tn(n,i))return;Xg.set(i),t.uniformMatrix3fv(this.addr,!1,Xg),Cn(n,i)}}function hE(t,e){let n=this.cache,i=e.elements;if(i===void 0){if(Tn(n,e))return;t.uniformMatrix4fv(this.addr,!1,e),Cn(n,e)}else{if(Tn(n,i))return;Wg.set(i),t.uniformMatrix4fv(this.addr,!1,Wg),Cn(n,i)}}function fE(t,e){let n=this.cache;n[0]!==e&&(t.uniform1i(this.addr,e),n[0]=e)}function dE(t,e){let n=this.cache;if(e.x!==void 0)(n[0]!==e.x||n[1]!==e.y)&&(t.uniform2i(this.addr,e.x,e.y),n[0]=e.x,n[1]=e.y);else{if(Tn(n,e))return;t.uniform2iv(this.addr,e),Cn(n,e)}}function pE(t,e){let n=this.cache;if(e.x!==void 0)(n[0]!==e.x||n[1]!==e.y||n[2]!==e.z)&&(t.uniform3i(this.addr,e.x,e.y,e.z),n[0]=e.x,n[1]=e.y,n[2]=e.z);else{if(Tn(n,e))return;t.uniform3iv(this.addr,e),Cn(n,e)}}function mE(t,e){let n=this.cache;if(e.x!==void 0)(n[0]!==e.x||n[1]!==e.y||n[2]!==e.z||n[3]!==e.w)&&(t.uniform4i(this.addr,e.x,e.y,e.z,e.w),n[0]=e.x,n[1]=e.y,n[2]=e.z,n[3]=e.w);else{if(Tn(n,e))return;t.uniform4iv(this.addr,e),Cn(n,e)}}function gE(t,e){let n=this.cache;n[0]!==e&&(t.uniform1ui(this.addr,e),n[0]=e)}function _E(t,e){let n=this.cache;if(e.x!==void 0)(n[0]!==e.x||n[1]!==e.y)&&(t.uniform2ui(this.addr,e.x,e.y),n[0]=e.x,n[1]=e.y);else{if(Tn(n,e))return;t.uniform2uiv(this.addr,e),Cn(n,e)}}function xE(t,e){let n=this.cache;if(e.x!==void 0)(n[0]!==e.x||n[1]!==e.y||n[2]!==e.z)&&(t.uniform3ui(this.addr,e.x,e.y,e.z),n[0]=e.x,n[1]=e.y,n[2]=e.z);else{if(Tn(n,e))return;t.uniform3uiv(this.addr,e),Cn(n,e)}}function vE(t,e){let n=this.cache;if(e.x!==void 0)(n[0]!==e.x||n[1]!==e.y||n[2]!==e.z||n[3]!==e.w)&&(t.uniform4ui(this.addr,e.x,e.y,e.z,e.w),n[0]=e.x,n[1]=e.y,n[2]=e.z,n[3]=e.w);else{if(Tn(n,e))return;t.uniform4uiv(this.addr,e),Cn(n,e)}}function zu(t){return t.version===0&&(t.compareFunction=Zf,t.needsUpdate=!0),t}function yE(t,e,n){let i=this.cache,s=n.allocateTextureUnit();i[0]!==s&&(t.uniform1i(this.addr,s),i[0]=s);let r;this.type===t.SAMPLER_2D_SHADOW?r=zu(u0):r=c0,n.setTexture2D(e||r,s)}function SE(t,e,n){let i=this.cache,s=n.allocateTextureUnit();i[0]!==s&&(t.uniform1i(this.addr,s),i[0]=s),n.setTexture3D(e||d0,s)}function ME(t,e,n){let i=this.cache,s=n.allocateTextureUnit();i[0]!==s&&(t.uniform1i(this.addr,s),i[0]=s);let r;this.type===t.SAMPLER_CUBE_SHADOW?r=zu(h0):r=p0,n.setTextureCube(e||r,s)}function bE(t,e,n){let i=this.cache,s=n.allocateTextureUnit();i[0]!==s&&(t.uniform1i(this.addr,s),i[0]=s),n.setTexture2DArray(e||f0,s)}function wE(t){switch(t){case 5126:return rE;case 35664:return oE;case 35665:return aE;case 35666:return lE;case 35674:return cE;case 35675:return uE;case 35676:return hE;case 5124:case 35670:return fE;case 35667:case 35671:return dE;case 35668:case 35672:return pE;case 35669:case 35673:return mE;case 5125:return gE;case 36294:return _E;case 36295:return xE;case 36296:return vE;case 35678:case 36198:case 36298:case 36306:case 35682:return yE;case 35679:case 36299:case 36307:return SE;case 35680:case 36300:case 36308:case 36293:return ME;case 36289:case 36303:case 36311:case 36292:return bE}}function EE(t,e){t.uniform1fv(this.addr,e)}function AE(t,e){let n=Do(e,this.size,2);t.uniform2fv(this.addr,n)}function TE(t,e){let n=Do(e,this.size,3);t.uniform3fv(this.addr,n)}function CE(t,e){let n=Do(e,this.size,4);t.uniform4fv(this.addr,n)}function RE(t,e){let n=Do(e,this.size,4);t.uniformMatrix2fv(this.addr,!1,n)}function PE(t,e){let n=Do(e,this.size,9);t.uniformMatrix3fv(this.addr,!1,n)}function IE(t,e){let n=Do(e,this.size,16);t.uniformMatrix4fv(this.addr,!1,n)}function LE(t,e){t.uniform1iv(this.addr,e)}function NE(t,e){t.uniform2iv(this.addr,e)}function DE(t,e){t.uniform3iv(this.addr,e)}function UE(t,e){t.uniform4iv(this.addr,e)}function FE(t,e){t.uniform1uiv(this.addr,e)}function OE(t,e){t.uniform2uiv(this.addr,e)}function BE(t,e){t.uniform3uiv(this.addr,e)}function kE(t,e){t.uniform4uiv(this.addr,e)}function zE(t,e,n){let i=this.cache,s=e.length,r=ku(n,s);Tn(i,r)||(t.uniform1iv(this.addr,r),Cn(i,r));let o;this.type===t.SAMPLER_2D_SHADOW?o=zu(u0):o=c0;for(let a=0;a!==s;++a)n.setTexture2D(e[a]||o,r[a])}function GE(t,e,n){let i=this.cache,s=e.length,r=ku(n,s);Tn(i,r)||(t.uniform1iv(this.addr,r),Cn(i,r));for(let o=0;o!==s;++o)n.setTexture3D(e[o]||d0,r[o])}function VE(t,e,n){let i=this.cache,s=e.length,r=ku(n,s);Tn(i,r)||(t.uniform1iv(this.addr,r),Cn(i,r));let o;this.type===t.SAMPLER_CUBE_SHADOW?o=zu(h0):o=p0;for(let a=0;a!==s;++a)n.setTextureCube(e[a]||o,r[a])}function HE(t,e,n){let i=this.cache,s=e.length,r=ku(n,s);Tn(i,r)||(t.uniform1iv(this.addr,r),Cn(i,r));for(let o=0;o!==s;++o)n.setTexture2DArray(e[o]||f0,r[o])}function WE(t){switch(t){case 5126:return EE;case 35664:return AE;case 35665:return TE;case 35666:return CE;case 35674:return RE;case 35675:return PE;case 35676:return IE;case 5124:case 35670:return LE;case 35667:case 35671:return NE;case 35668:case 35672:return DE;case 35669:case 35673:return UE;case 5125:return FE;case 36294:return OE;case 36295:return BE;case 36296:return kE;case 35678:case 36198:case 36298:case 36306:case 35682:return zE;case 35679:case 36299:case 36307:return GE;case 35680:case 36300:case 36308:case 36293:return VE;case 36289:case 36303:case 36311:case 36292:return HE}}var rd=class{constructor(e,n,i){this.id=e,this.addr=i,this.cache=[],this.type=n.type,this.setValue=wE(n.type)}},od=class{constructor(e,n,i){this.id=e,this.addr=i,this.cache=[],this.type=n.type,this.size=n.size,this.setValue=WE(n.type)}},ad=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,n,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,n[a.id],i)}}},id=/(\w+)(\])?(\[|\.)?/g;function $g(t,e){t.seq.push(e),t.map[e.id]=e}function XE(t,e,n){let i=t.name,s=i.length;for(id.lastIndex=0;;){let r=id.exec(i),o=id.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){$g(n,c===void 0?new rd(a,t,e):new od(a,t,e));break}else{let h=n.map[a];h===void 0&&(h=new ad(a),$g(n,h)),n=h}}}var No=class{constructor(e,n){this.seq=[],this.map={};let i=e.getProgramParameter(n,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(n,o),l=e.getUniformLocation(n,a.name);XE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,n,i,s){let r=this.map[n];r!==void 0&&r.setValue(e,i,s)}setOptional(e,n,i){let s=n[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,n,i,s){for(let r=0,o=n.length;r!==o;++r){let a=n[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,n){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in n&&i.push(o)}return i}};function Yg(t,e,n){let i=t.createShader(e);return t.shaderSource(i,n),t.compileShader(i),i}var qE=37297,$E=0;function YE(t,e){let n=t.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,n.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${n[o]}`)}return i.join(`
`)}var Zg=new st;function ZE(t){xt._getMatrix(Zg,xt.workingColorSpace,t);let e=`mat3( ${Zg.elements.map(n=>n.toFixed(4))} )`;switch(xt.getTransfer(t)){case ba:return[e,"LinearTransferOETF"];case Rt:return[e,"sRGBTransferOETF"];default:return Je("WebGLProgram: Unsupported color space: ",t),[e,"LinearTransferOETF"]}}function jg(t,e,n){let i=t.getShaderParameter(e,t.COMPILE_STATUS),r=(t.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return n.toUpperCase()+`

`+r+`

`+YE(t.getShaderSource(e),a)}else return r}function jE(t,e){let n=ZE(e);return[`vec4 ${t}( vec4 value ) {`,`	return ${n[1]}( vec4( ${n[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var JE={[Df]:"Linear",[Uf]:"Reinhard",[Ff]:"Cineon",[Of]:"ACESFilmic",[kf]:"AgX",[Ha]:"Neutral",[Bf]:"Custom"};function KE(t,e){let n=JE[e];return n===void 0?(Je("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+t+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+t+"( vec3 color ) { return "+n+"ToneMapping( color ); }"}var Fu=new F;function QE(){xt.getLuminanceCoefficients(Fu);let t=Fu.x.toFixed(4),e=Fu.y.toFixed(4),n=Fu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${t}, ${e}, ${n} );`,"	return dot( weights, rgb );","}"].join(`
`)}function eA(t){return[t.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",t.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(nl).join(`
`)}function tA(t){let e=[];for(let n in t){let i=t[n];i!==!1&&e.push("#define "+n+" "+i)}return e.join(`
`)}function nA(t,e){let n={},i=t.getProgramParameter(e,t.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=t.getActiveAttrib(e,s),o=r.name,a=1;r.type===t.FLOAT_MAT2&&(a=2),r.type===t.FLOAT_MAT3&&(a=3),r.type===t.FLOAT_MAT4&&(a=4),n[o]={type:r.type,location:t.getAttribLocation(e,o),locationSize:a}}return n}function nl(t){return t!==""}function Jg(t,e){let n=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return t.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,n).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Kg(t,e){return t.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var iA=/^[ \t]*#include +<([\w\d./]+)>/gm;function ld(t){return t.replace(iA,sA)}function sA(t,e){let n=ft[e];if(n===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return ld(n)}var rA=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Qg(t){return t.replace(rA,oA)}function oA(t,e,n,i){let s="";for(let r=parseInt(e);r<parseInt(n);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function e0(t){let e=`precision ${t.precision} float;
	precision ${t.precision} int;
	precision ${t.precision} sampler2D;
	precision ${t.precision} samplerCube;
	precision ${t.precision} sampler3D;
	precision ${t.precision} sampler2DArray;
	precision ${t.precision} sampler2DShadow;
	precision ${t.precision} samplerCubeShadow;
	precision ${t.precision} sampler2DArrayShadow;
	precision ${t.precision} isampler2D;
	precision ${t.precision} isampler3D;
	precision ${t.precision} isamplerCube;
	precision ${t.precision} isampler2DArray;
	precision ${t.precision} usampler2D;
	precision ${t.precision} usampler3D;
	precision ${t.precision} usamplerCube;
	precision ${t.precision} usampler2DArray;
	`;return t.precision==="highp"?e+=`
#define HIGH_PRECISION`:t.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:t.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var aA={[Er]:"SHADOWMAP_TYPE_PCF",[Ro]:"SHADOWMAP_TYPE_VSM"};function lA(t){return aA[t.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var cA={[Io]:"ENVMAP_MODE_REFRACTION"};function uA(t){return t.envMap===!1?"ENVMAP_MODE_REFLECTION":cA[t.envMapMode]||"ENVMAP_MODE_REFLECTION"}var hA={[Zc]:"ENVMAP_BLENDING_MULTIPLY",[_g]:"ENVMAP_BLENDING_MIX",[xg]:"ENVMAP_BLENDING_ADD"};function fA(t){return t.envMap===!1?"ENVMAP_BLENDING_NONE":hA[t.combine]||"ENVMAP_BLENDING_NONE"}function dA(t,e,n,i){let s=t.getContext(),r=n.defines,o=n.vertexShader,a=n.fragmentShader,l=lA(n),c=n.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=uA(n),h=fA(n),f=eA(n),d=tA(r),g=s.createProgram(),y,p,m=n.glslVersion?"#version "+n.glslVersion+`
`:"";n.isRawShaderMaterial?(y=["#define SHADER_TYPE "+n.shaderType,"#define SHADER_NAME "+n.shaderName,d].filter(nl).join(`
`),y.length>0&&(y+=`
`),p=["#define SHADER_TYPE "+n.shaderType,"#define SHADER_NAME "+n.shaderName,d].filter(nl).join(`
`),p.length>0&&(p+=`
`)):(y=[e0(n),"#define SHADER_TYPE "+n.shaderType,"#define SHADER_NAME "+n.shaderName,d,n.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",n.batching?"#define USE_BATCHING":"",n.batchingColor?"#define USE_BATCHING_COLOR":"",n.instancing?"#define USE_INSTANCING":"",n.instancingColor?"#define USE_INSTANCING_COLOR":"",n.instancingMorph?"#define USE_INSTANCING_MORPH":"",n.useFog&&n.fog?"#define USE_FOG":"",n.useFog&&n.fogExp2?"#define FOG_EXP2":"",n.map?"#define USE_MAP":"",n.envMap?"#define USE_ENVMAP":"",n.envMap?"#define "+u:"",n.lightMap?"#define USE_LIGHTMAP":"",n.aoMap?"#define USE_AOMAP":"",n.bumpMap?"#define USE_BUMPMAP":"",n.normalMap?"#define USE_NORMALMAP":"",n.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",n.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",n.displacementMap?"#define USE_DISPLACEMENTMAP":"",n.emissiveMap?"#define USE_EMISSIVEMAP":"",n.anisotropy?"#define USE_ANISOTROPY":"",n.anisotropyMap?"#define USE_ANISOTROPYMAP":"",n.clearcoatMap?"#define USE_CLEARCOATMAP":"",n.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",n.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",n.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",n.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",n.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",n.specularMap?"#define USE_SPECULARMAP":"",n.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",n.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",n.roughnessMap?"#define USE_ROUGHNESSMAP":"",n.metalnessMap?"#define USE_METALNESSMAP":"",n.alphaMap?"#define USE_ALPHAMAP":"",n.alphaHash?"#define USE_ALPHAHASH":"",n.transmission?"#define USE_TRANSMISSION":"",n.transmissionMap?"#define USE_TRANSMISSIONMAP":"",n.thicknessMap?"#define USE_THICKNESSMAP":"",n.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",n.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",n.mapUv?"#define MAP_UV "+n.mapUv:"",n.alphaMapUv?"#define ALPHAMAP_UV "+n.alphaMapUv:"",n.lightMapUv?"#define LIGHTMAP_UV "+n.lightMapUv:"",n.aoMapUv?"#define AOMAP_UV "+n.aoMapUv:"",n.emissiveMapUv?"#define EMISSIVEMAP_UV "+n.emissiveMapUv:"",n.bumpMapUv?"#define BUMPMAP_UV "+n.bumpMapUv:"",n.normalMapUv?"#define NORMALMAP_UV "+n.normalMapUv:"",n.displacementMapUv?"#define DISPLACEMENTMAP_UV "+n.displacementMapUv:"",n.metalnessMapUv?"#define METALNESSMAP_UV "+n.metalnessMapUv:"",n.roughnessMapUv?"#define ROUGHNESSMAP_UV "+n.roughnessMapUv:"",n.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+n.anisotropyMapUv:"",n.clearcoatMapUv?"#define CLEARCOATMAP_UV "+n.clearcoatMapUv:"",n.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+n.clearcoatNormalMapUv:"",n.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+n.clearcoatRoughnessMapUv:"",n.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+n.diffuseRoughnessMapUv:"",n.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+n.iridescenceMapUv:"",n.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+n.iridescenceThicknessMapUv:"",n.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+n.sheenColorMapUv:"",n.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+n.sheenRoughnessMapUv:"",n.specularMapUv?"#define SPECULARMAP_UV "+n.specularMapUv:"",n.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+n.specularColorMapUv:"",n.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+n.specularIntensityMapUv:"",n.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+n.transmissionMapUv:"",n.thicknessMapUv?"#define THICKNESSMAP_UV "+n.thicknessMapUv:"",n.vertexTangents&&n.flatShading===!1?"#define USE_TANGENT":"",n.vertexNormals?"#define HAS_NORMAL":"",n.vertexColors?"#define USE_COLOR":"",n.vertexAlphas?"#define USE_COLOR_ALPHA":"",n.vertexUv1s?"#define USE_UV1":"",n.vertexUv2s?"#define USE_UV2":"",n.vertexUv3s?"#define USE_UV3":"",n.pointsUvs?"#define USE_POINTS_UV":"",n.flatShading?"#define FLAT_SHADED":"",n.skinning?"#define USE_SKINNING":"",n.morphTargets?"#define USE_MORPHTARGETS":"",n.morphNormals&&n.flatShading===!1?"#define USE_MORPHNORMALS":"",n.morphColors?"#define USE_MORPHCOLORS":"",n.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+n.morphTextureStride:"",n.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+n.morphTargetsCount:"",n.doubleSided?"#define DOUBLE_SIDED":"",n.flipSided?"#define FLIP_SIDED":"",n.shadowMapEnabled?"#define USE_SHADOWMAP":"",n.shadowMapEnabled?"#define "+l:"",n.sizeAttenuation?"#define USE_SIZEATTENUATION":"",n.numLightProbes>0?"#define USE_LIGHT_PROBES":"",n.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",n.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(nl).join(`
`),p=[e0(n),"#define SHADER_TYPE "+n.shaderType,"#define SHADER_NAME "+n.shaderName,d,n.useFog&&n.fog?"#define USE_FOG":"",n.useFog&&n.fogExp2?"#define FOG_EXP2":"",n.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",n.map?"#define USE_MAP":"",n.matcap?"#define USE_MATCAP":"",n.envMap?"#define USE_ENVMAP":"",n.envMap?"#define "+c:"",n.envMap?"#define "+u:"",n.envMap?"#define "+h:"",n.envMapPMREM?"#define ENVMAP_MAX_LOD "+n.envMapMaxLod+".0":"",n.envMapPMREM?"#define ENVMAP_SIZE "+n.envMapSize+".0":"",n.lightMap?"#define USE_LIGHTMAP":"",n.aoMap?"#define USE_AOMAP":"",n.bumpMap?"#define USE_BUMPMAP":"",n.normalMap?"#define USE_NORMALMAP":"",n.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",n.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",n.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",n.emissiveMap?"#define USE_EMISSIVEMAP":"",n.anisotropy?"#define USE_ANISOTROPY":"",n.anisotropyMap?"#define USE_ANISOTROPYMAP":"",n.clearcoat?"#define USE_CLEARCOAT":"",n.clearcoatMap?"#define USE_CLEARCOATMAP":"",n.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",n.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",n.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",n.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",n.dispersion?"#define USE_DISPERSION":"",n.retroreflection?"#define USE_RETROREFLECTION":"",n.iridescence?"#define USE_IRIDESCENCE":"",n.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",n.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",n.specularMap?"#define USE_SPECULARMAP":"",n.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",n.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",n.roughnessMap?"#define USE_ROUGHNESSMAP":"",n.metalnessMap?"#define USE_METALNESSMAP":"",n.alphaMap?"#define USE_ALPHAMAP":"",n.alphaTest?"#define USE_ALPHATEST":"",n.alphaHash?"#define USE_ALPHAHASH":"",n.sheen?"#define USE_SHEEN":"",n.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",n.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",n.transmission?"#define USE_TRANSMISSION":"",n.transmissionMap?"#define USE_TRANSMISSIONMAP":"",n.thicknessMap?"#define USE_THICKNESSMAP":"",n.vertexTangents&&n.flatShading===!1?"#define USE_TANGENT":"",n.vertexColors||n.instancingColor?"#define USE_COLOR":"",n.vertexAlphas||n.batchingColor?"#define USE_COLOR_ALPHA":"",n.vertexUv1s?"#define USE_UV1":"",n.vertexUv2s?"#define USE_UV2":"",n.vertexUv3s?"#define USE_UV3":"",n.pointsUvs?"#define USE_POINTS_UV":"",n.gradientMap?"#define USE_GRADIENTMAP":"",n.flatShading?"#define FLAT_SHADED":"",n.doubleSided?"#define DOUBLE_SIDED":"",n.flipSided?"#define FLIP_SIDED":"",n.shadowMapEnabled?"#define USE_SHADOWMAP":"",n.shadowMapEnabled?"#define "+l:"",n.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",n.numLightProbes>0?"#define USE_LIGHT_PROBES":"",n.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",n.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",n.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",n.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",n.toneMapping!==hs?"#define TONE_MAPPING":"",n.toneMapping!==hs?ft.tonemapping_pars_fragment:"",n.toneMapping!==hs?KE("toneMapping",n.toneMapping):"",n.dithering?"#define DITHERING":"",n.opaque?"#define OPAQUE":"",ft.colorspace_pars_fragment,jE("linearToOutputTexel",n.outputColorSpace),QE(),n.useDepthPacking?"#define DEPTH_PACKING "+n.depthPacking:"",`
`].filter(nl).join(`
`)),o=ld(o),o=Jg(o,n),o=Kg(o,n),a=ld(a),a=Jg(a,n),a=Kg(a,n),o=Qg(o),a=Qg(a),n.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,y=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,p=["#define varying in",n.glslVersion===jf?"":"layout(location = 0) out highp vec4 pc_fragColor;",n.glslVersion===jf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let v=m+y+o,T=m+p+a,S=Yg(s,s.VERTEX_SHADER,v),C=Yg(s,s.FRAGMENT_SHADER,T);s.attachShader(g,S),s.attachShader(g,C),n.index0AttributeName!==void 0?s.bindAttribLocation(g,0,n.index0AttributeName):n.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function A(L){if(t.debug.checkShaderErrors){let N=s.getProgramInfoLog(g)||"",k=s.getShaderInfoLog(S)||"",H=s.getShaderInfoLog(C)||"",I=N.trim(),z=k.trim(),$=H.trim(),V=!0,ae=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(V=!1,typeof t.debug.onShaderError=="function")t.debug.onShaderError(s,g,S,C);else{let q=jg(s,S,"vertex"),K=jg(s,C,"fragment");tt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+I+`
`+q+`
`+K)}else I!==""?Je("WebGLProgram: Program Info Log:",I):(z===""||$==="")&&(ae=!1);ae&&(L.diagnostics={runnable:V,programLog:I,vertexShader:{log:z,prefix:y},fragmentShader:{log:$,prefix:p}})}s.deleteShader(S),s.deleteShader(C),_=new No(s,g),w=nA(s,g)}let _;this.getUniforms=function(){return _===void 0&&A(this),_};let w;this.getAttributes=function(){return w===void 0&&A(this),w};let U=n.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(g,qE)),U},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=n.shaderType,this.name=n.shaderName,this.id=$E++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=S,this.fragmentShader=C,this}var pA=0,cd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,n,i){let s=this._getShaderCacheForMaterial(e);return s.has(n)===!1&&(s.add(n),n.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let n=this.materialCache.get(e);for(let i of n)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let n=this.materialCache,i=n.get(e);return i===void 0&&(i=new Set,n.set(e,i)),i}_getShaderStage(e){let n=this.shaderCache,i=n.get(e);return i===void 0&&(i=new ud(e),n.set(e,i)),i}},ud=class{constructor(e){this.id=pA++,this.code=e,this.usedTimes=0}};function mA(t){return t===Zi||t===ja||t===Ja}function gA(t,e,n,i,s,r){let o=new Mo,a=new cd,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(_){return l.add(_),_===0?"uv":`uv${_}`}function g(_,w,U,L,N,k){let H=L.fog,I=N.geometry,z=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?L.environment:null,$=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,V=e.get(_.envMap||z,$),ae=f[_.type],q=i.precision;_.precision!==null&&(q=i.getMaxPrecision(_.precision),q!==_.precision&&Je("WebGLProgram.getParameters:",_.precision,"not supported, using",q,"instead."));let K=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,ne=K!==void 0?K.length:0,he=0;I.morphAttributes.position!==void 0&&(he=1),I.morphAttributes.normal!==void 0&&(he=2),I.morphAttributes.color!==void 0&&(he=3);let fe,Q,me,xe;if(ae){let Pe=ds[ae];fe=Pe.vertexShader,Q=Pe.fragmentShader}else{fe=_.vertexShader,Q=_.fragmentShader;let Pe=a.getVertexShaderStage(_),ct=a.getFragmentShaderStage(_);a.update(_,Pe,ct),me=Pe.id,xe=ct.id}let Re=t.getRenderTarget(),we=t.state.buffers.depth.getReversed(),Xe=N.isInstancedMesh===!0,at=N.isBatchedMesh===!0,He=!!_.map,dt=!!_.matcap,ut=!!V,rt=ut&&V.isPMREMTexture===!0,Kt=!!_.aoMap,Vt=!!_.lightMap,_n=!!_.bumpMap&&_.wireframe===!1,Ut=!!_.normalMap,Nn=!!_.displacementMap,Mt=!!_.emissiveMap,En=!!_.metalnessMap,rn=!!_.roughnessMap,xn=_.anisotropy>0,B=_.clearcoat>0,Ie=_.diffuseRoughness>0,je=_.dispersion>0,lt=_.retroreflectivity>0,Ee=_.iridescence>0,Ot=_.sheen>0,Ve=_.transmission>0,Ye=xn&&!!_.anisotropyMap,R=B&&!!_.clearcoatMap,M=B&&!!_.clearcoatNormalMap,X=B&&!!_.clearcoatRoughnessMap,ue=Ie&&!!_.diffuseRoughnessMap,re=Ee&&!!_.iridescenceMap,_e=Ee&&!!_.iridescenceThicknessMap,ve=Ot&&!!_.sheenColorMap,ee=Ot&&!!_.sheenRoughnessMap,ie=!!_.specularMap,pe=!!_.specularColorMap,O=!!_.specularIntensityMap,se=Ve&&!!_.transmissionMap,te=Ve&&!!_.thicknessMap,Ae=!!_.gradientMap,ge=!!_.alphaMap,be=_.alphaTest>0,We=!!_.alphaHash,Qe=!!_.extensions,ce=hs;_.toneMapped&&(Re===null||Re.isXRRenderTarget===!0)&&(ce=t.toneMapping);let ke=rt?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,et={shaderID:ae,shaderType:_.type,shaderName:_.name,vertexShader:fe,fragmentShader:Q,defines:_.defines,customVertexShaderID:me,customFragmentShaderID:xe,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:q,batching:at,batchingColor:at&&N._colorsTexture!==null,instancing:Xe,instancingColor:Xe&&N.instanceColor!==null,instancingMorph:Xe&&N.morphTexture!==null,outputColorSpace:Re===null?t.outputColorSpace:Re.isXRRenderTarget===!0?Re.texture.colorSpace:xt.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:He,matcap:dt,envMap:ut,envMapMode:ut&&V.mapping,envMapPMREM:rt,envMapMaxLod:rt?ke.length-1:null,envMapSize:rt?ke[0].width:null,aoMap:Kt,lightMap:Vt,bumpMap:_n,normalMap:Ut,displacementMap:Nn,emissiveMap:Mt,normalMapObjectSpace:Ut&&_.normalMapType===Sg,normalMapTangentSpace:Ut&&_.normalMapType===Ka,packedNormalMap:Ut&&_.normalMapType===Ka&&mA(_.normalMap.format),metalnessMap:En,roughnessMap:rn,anisotropy:xn,anisotropyMap:Ye,clearcoat:B,clearcoatMap:R,clearcoatNormalMap:M,clearcoatRoughnessMap:X,diffuseRoughness:Ie,diffuseRoughnessMap:ue,dispersion:je,retroreflection:lt,iridescence:Ee,iridescenceMap:re,iridescenceThicknessMap:_e,sheen:Ot,sheenColorMap:ve,sheenRoughnessMap:ee,specularMap:ie,specularColorMap:pe,specularIntensityMap:O,transmission:Ve,transmissionMap:se,thicknessMap:te,gradientMap:Ae,opaque:_.transparent===!1&&_.blending===Po&&_.alphaToCoverage===!1,alphaMap:ge,alphaTest:be,alphaHash:We,combine:_.combine,mapUv:He&&d(_.map.channel),aoMapUv:Kt&&d(_.aoMap.channel),lightMapUv:Vt&&d(_.lightMap.channel),bumpMapUv:_n&&d(_.bumpMap.channel),normalMapUv:Ut&&d(_.normalMap.channel),displacementMapUv:Nn&&d(_.displacementMap.channel),emissiveMapUv:Mt&&d(_.emissiveMap.channel),metalnessMapUv:En&&d(_.metalnessMap.channel),roughnessMapUv:rn&&d(_.roughnessMap.channel),anisotropyMapUv:Ye&&d(_.anisotropyMap.channel),clearcoatMapUv:R&&d(_.clearcoatMap.channel),clearcoatNormalMapUv:M&&d(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&d(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&d(_.diffuseRoughnessMap.channel),iridescenceMapUv:re&&d(_.iridescenceMap.channel),iridescenceThicknessMapUv:_e&&d(_.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&d(_.sheenColorMap.channel),sheenRoughnessMapUv:ee&&d(_.sheenRoughnessMap.channel),specularMapUv:ie&&d(_.specularMap.channel),specularColorMapUv:pe&&d(_.specularColorMap.channel),specularIntensityMapUv:O&&d(_.specularIntensityMap.channel),transmissionMapUv:se&&d(_.transmissionMap.channel),thicknessMapUv:te&&d(_.thicknessMap.channel),alphaMapUv:ge&&d(_.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Ut||xn),vertexNormals:!!I.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!I.attributes.uv&&(He||ge),fog:!!H,useFog:_.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||I.attributes.normal===void 0&&Ut===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:we,skinning:N.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:ne,morphTextureStride:he,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:k.filter(Pe=>Pe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:t.shadowMap.enabled&&U.length>0,shadowMapType:t.shadowMap.type,toneMapping:ce,decodeVideoTexture:He&&_.map.isVideoTexture===!0&&xt.getTransfer(_.map.colorSpace)===Rt,decodeVideoTextureEmissive:Mt&&_.emissiveMap.isVideoTexture===!0&&xt.getTransfer(_.emissiveMap.colorSpace)===Rt,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Ri,flipSided:_.side===ri,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:Qe&&_.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Qe&&_.extensions.multiDraw===!0||at)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return et.vertexUv1s=l.has(1),et.vertexUv2s=l.has(2),et.vertexUv3s=l.has(3),l.clear(),et}function y(_){let w=[];if(_.shaderID?w.push(_.shaderID):(w.push(_.customVertexShaderID),w.push(_.customFragmentShaderID)),_.defines!==void 0)for(let U in _.defines)w.push(U),w.push(_.defines[U]);return _.isRawShaderMaterial===!1&&(p(w,_),m(w,_),w.push(t.outputColorSpace)),w.push(_.customProgramCacheKey),w.join()}function p(_,w){_.push(w.precision),_.push(w.outputColorSpace),_.push(w.envMapMode),_.push(w.envMapPMREM),_.push(w.envMapMaxLod),_.push(w.envMapSize),_.push(w.mapUv),_.push(w.alphaMapUv),_.push(w.lightMapUv),_.push(w.aoMapUv),_.push(w.bumpMapUv),_.push(w.normalMapUv),_.push(w.displacementMapUv),_.push(w.emissiveMapUv),_.push(w.metalnessMapUv),_.push(w.roughnessMapUv),_.push(w.anisotropyMapUv),_.push(w.clearcoatMapUv),_.push(w.clearcoatNormalMapUv),_.push(w.clearcoatRoughnessMapUv),_.push(w.diffuseRoughnessMapUv),_.push(w.iridescenceMapUv),_.push(w.iridescenceThicknessMapUv),_.push(w.sheenColorMapUv),_.push(w.sheenRoughnessMapUv),_.push(w.specularMapUv),_.push(w.specularColorMapUv),_.push(w.specularIntensityMapUv),_.push(w.transmissionMapUv),_.push(w.thicknessMapUv),_.push(w.combine),_.push(w.fogExp2),_.push(w.sizeAttenuation),_.push(w.morphTargetsCount),_.push(w.numSunLights),_.push(w.numDirLights),_.push(w.numPointLights),_.push(w.numSpotLights),_.push(w.numSpotLightMaps),_.push(w.numHemiLights),_.push(w.numRectAreaLights),_.push(w.numSunLightShadows),_.push(w.numDirLightShadows),_.push(w.numPointLightShadows),_.push(w.numSpotLightShadows),_.push(w.numSpotLightShadowsWithMaps),_.push(w.numLightProbes),_.push(w.numLightProbeGrids),_.push(w.shadowMapType),_.push(w.toneMapping),_.push(w.numClippingPlanes),_.push(w.numClipIntersection),_.push(w.depthPacking)}function m(_,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function v(_){let w=f[_.type],U;if(w){let L=ds[w];U=Ug.clone(L.uniforms)}else U=_.uniforms;return U}function T(_,w){let U=u.get(w);return U!==void 0?++U.usedTimes:(U=new dA(t,w,_,s),c.push(U),u.set(w,U)),U}function S(_){if(--_.usedTimes===0){let w=c.indexOf(_);c[w]=c[c.length-1],c.pop(),u.delete(_.cacheKey),_.destroy()}}function C(_){a.remove(_)}function A(){a.dispose()}return{getParameters:g,getProgramCacheKey:y,getUniforms:v,acquireProgram:T,releaseProgram:S,releaseShaderCache:C,programs:c,dispose:A}}function _A(){let t=new WeakMap;function e(o){return t.has(o)}function n(o){let a=t.get(o);return a===void 0&&(a={},t.set(o,a)),a}function i(o){t.delete(o)}function s(o,a,l){t.get(o)[a]=l}function r(){t=new WeakMap}return{has:e,get:n,remove:i,update:s,dispose:r}}function xA(t,e){return t.groupOrder!==e.groupOrder?t.groupOrder-e.groupOrder:t.renderOrder!==e.renderOrder?t.renderOrder-e.renderOrder:t.material.id!==e.material.id?t.material.id-e.material.id:t.materialVariant!==e.materialVariant?t.materialVariant-e.materialVariant:t.z!==e.z?t.z-e.z:t.id-e.id}function t0(t,e){return t.groupOrder!==e.groupOrder?t.groupOrder-e.groupOrder:t.renderOrder!==e.renderOrder?t.renderOrder-e.renderOrder:t.z!==e.z?e.z-t.z:t.id-e.id}function n0(){let t=[],e=0,n=[],i=[],s=[];function r(){e=0,n.length=0,i.length=0,s.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,g,y,p,m){let v=t[e];return v===void 0?(v={id:f.id,object:f,geometry:d,material:g,materialVariant:o(f),groupOrder:y,renderOrder:f.renderOrder,z:p,group:m},t[e]=v):(v.id=f.id,v.object=f,v.geometry=d,v.material=g,v.materialVariant=o(f),v.groupOrder=y,v.renderOrder=f.renderOrder,v.z=p,v.group=m),e++,v}function l(f,d,g,y,p,m,v){v.reversedDepth===!0&&(p=-p);let T=a(f,d,g,y,p,m);g.transmission>0?i.push(T):g.transparent===!0?s.push(T):n.push(T)}function c(f,d,g,y,p,m){let v=a(f,d,g,y,p,m);g.transmission>0?i.unshift(v):g.transparent===!0?s.unshift(v):n.unshift(v)}function u(f,d){n.length>1&&n.sort(f||xA),i.length>1&&i.sort(d||t0),s.length>1&&s.sort(d||t0)}function h(){for(let f=e,d=t.length;f<d;f++){let g=t[f];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:n,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function vA(){let t=new WeakMap;function e(i,s){let r=t.get(i),o;return r===void 0?(o=new n0,t.set(i,[o])):s>=r.length?(o=new n0,r.push(o)):o=r[s],o}function n(){t=new WeakMap}return{get:e,dispose:n}}function yA(){let t={};return{get:function(e){if(t[e.id]!==void 0)return t[e.id];let n;switch(e.type){case"SunLight":case"DirectionalLight":n={direction:new F,color:new $e};break;case"SpotLight":n={position:new F,direction:new F,color:new $e,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":n={position:new F,color:new $e,distance:0,decay:0};break;case"HemisphereLight":n={direction:new F,skyColor:new $e,groundColor:new $e};break;case"RectAreaLight":n={color:new $e,position:new F,halfWidth:new F,halfHeight:new F};break}return t[e.id]=n,n}}}function SA(){let t={};return{get:function(e){if(t[e.id]!==void 0)return t[e.id];let n;switch(e.type){case"SunLight":case"DirectionalLight":n={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it};break;case"SpotLight":n={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it};break;case"PointLight":n={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it,shadowCameraNear:1,shadowCameraFar:1e3};break}return t[e.id]=n,n}}}var MA=0;function bA(t,e){return(e.castShadow?2:0)-(t.castShadow?2:0)+(e.map?1:0)-(t.map?1:0)}function wA(t){let e=new yA,n=SA(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new F);let s=new F,r=new Dt,o=new Dt;function a(c){let u=0,h=0,f=0;for(let k=0;k<9;k++)i.probe[k].set(0,0,0);let d=0,g=0,y=0,p=0,m=0,v=0,T=0,S=0,C=0,A=0,_=0,w=0,U=0,L=0;c.sort(bA);for(let k=0,H=c.length;k<H;k++){let I=c[k],z=I.color,$=I.intensity,V=I.distance,ae=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===Zi?ae=I.shadow.map.texture:ae=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)u+=z.r*$,h+=z.g*$,f+=z.b*$;else if(I.isLightProbe){for(let q=0;q<9;q++)i.probe[q].addScaledVector(I.sh.coefficients[q],$);L++}else if(I.isSunLight){let q=e.get(I);if(q.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let K=I.shadow,ne=n.get(I);ne.shadowIntensity=K.intensity,ne.shadowBias=K.bias,ne.shadowNormalBias=K.normalBias,ne.shadowRadius=K.radius,ne.shadowMapSize.copy(K.mapSize).multiply(K.getFrameExtents()),i.sunShadow[g]=ne,i.sunShadowMap[g]=ae;let he=K.getViewportCount();for(let fe=0;fe<he;fe++)i.sunShadowMatrix[y+fe]=K.getMatrix(fe),i.sunShadowCascade[y+fe]=K._cascadeData[fe];y+=he,g++}i.sun[d]=q,d++}else if(I.isDirectionalLight){let q=e.get(I);if(q.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let K=I.shadow,ne=n.get(I);ne.shadowIntensity=K.intensity,ne.shadowBias=K.bias,ne.shadowNormalBias=K.normalBias,ne.shadowRadius=K.radius,ne.shadowMapSize=K.mapSize,i.directionalShadow[p]=ne,i.directionalShadowMap[p]=ae,i.directionalShadowMatrix[p]=I.shadow.matrix,C++}i.directional[p]=q,p++}else if(I.isSpotLight){let q=e.get(I);q.position.setFromMatrixPosition(I.matrixWorld),q.color.copy(z).multiplyScalar($),q.distance=V,q.coneCos=Math.cos(I.angle),q.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),q.decay=I.decay,i.spot[v]=q;let K=I.shadow;if(I.map&&(i.spotLightMap[w]=I.map,w++,K.updateMatrices(I),I.castShadow&&U++),i.spotLightMatrix[v]=K.matrix,I.castShadow){let ne=n.get(I);ne.shadowIntensity=K.intensity,ne.shadowBias=K.bias,ne.shadowNormalBias=K.normalBias,ne.shadowRadius=K.radius,ne.shadowMapSize=K.mapSize,i.spotShadow[v]=ne,i.spotShadowMap[v]=ae,_++}v++}else if(I.isRectAreaLight){let q=e.get(I);q.color.copy(z).multiplyScalar($),q.halfWidth.set(I.width*.5,0,0),q.halfHeight.set(0,I.height*.5,0),i.rectArea[T]=q,T++}else if(I.isPointLight){let q=e.get(I);if(q.color.copy(I.color).multiplyScalar(I.intensity),q.distance=I.distance,q.decay=I.decay,I.castShadow){let K=I.shadow,ne=n.get(I);ne.shadowIntensity=K.intensity,ne.shadowBias=K.bias,ne.shadowNormalBias=K.normalBias,ne.shadowRadius=K.radius,ne.shadowMapSize=K.mapSize,ne.shadowCameraNear=K.camera.near,ne.shadowCameraFar=K.camera.far,i.pointShadow[m]=ne,i.pointShadowMap[m]=ae,i.pointShadowMatrix[m]=I.shadow.matrix,A++}i.point[m]=q,m++}else if(I.isHemisphereLight){let q=e.get(I);q.skyColor.copy(I.color).multiplyScalar($),q.groundColor.copy(I.groundColor).multiplyScalar($),i.hemi[S]=q,S++}}T>0&&(t.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=De.LTC_FLOAT_1,i.rectAreaLTC2=De.LTC_FLOAT_2):(i.rectAreaLTC1=De.LTC_HALF_1,i.rectAreaLTC2=De.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;let N=i.hash;(N.sunLength!==d||N.directionalLength!==p||N.pointLength!==m||N.spotLength!==v||N.rectAreaLength!==T||N.hemiLength!==S||N.numSunShadows!==g||N.numDirectionalShadows!==C||N.numPointShadows!==A||N.numSpotShadows!==_||N.numSpotMaps!==w||N.numLightProbes!==L)&&(i.sun.length=d,i.directional.length=p,i.spot.length=v,i.rectArea.length=T,i.point.length=m,i.hemi.length=S,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+w-U,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=U,i.numLightProbes=L,N.sunLength=d,N.directionalLength=p,N.pointLength=m,N.spotLength=v,N.rectAreaLength=T,N.hemiLength=S,N.numSunShadows=g,N.numDirectionalShadows=C,N.numPointShadows=A,N.numSpotShadows=_,N.numSpotMaps=w,N.numLightProbes=L,i.version=MA++)}function l(c,u){let h=0,f=0,d=0,g=0,y=0,p=0,m=u.matrixWorldInverse;for(let v=0,T=c.length;v<T;v++){let S=c[v];if(S.isSunLight){let C=i.sun[h];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(m),h++}else if(S.isDirectionalLight){let C=i.directional[f];C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),f++}else if(S.isSpotLight){let C=i.spot[g];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(m),C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),g++}else if(S.isRectAreaLight){let C=i.rectArea[y];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(m),o.identity(),r.copy(S.matrixWorld),r.premultiply(m),o.extractRotation(r),C.halfWidth.set(S.width*.5,0,0),C.halfHeight.set(0,S.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),y++}else if(S.isPointLight){let C=i.point[d];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(m),d++}else if(S.isHemisphereLight){let C=i.hemi[p];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(m),p++}}}return{setup:a,setupView:l,state:i}}function i0(t){let e=new wA(t),n=[],i=[],s=[];function r(h){u.camera=h,n.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):n.push(h)}function a(h){i.push(h)}function l(){e.setup(n),s.sort((h,f)=>h.priority-f.priority||h.id-f.id)}function c(h){e.setupView(n,h)}let u={lightsArray:n,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function EA(t){let e=new WeakMap;function n(s,r=0){let o=e.get(s),a;return o===void 0?(a=new i0(t),e.set(s,[a])):r>=o.length?(a=new i0(t),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:n,dispose:i}}var AA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,TA=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,CA=[new F(1,0,0),new F(-1,0,0),new F(0,1,0),new F(0,-1,0),new F(0,0,1),new F(0,0,-1)],RA=[new F(0,-1,0),new F(0,-1,0),new F(0,0,1),new F(0,0,-1),new F(0,-1,0),new F(0,-1,0)],s0=new Dt,tl=new F,sd=new F;function PA(t,e,n){let i=new nr,s=new it,r=new it,o=new Ht,a=new Uc,l=new Fc,c={},u=n.maxTextureSize,h={[lr]:ri,[ri]:lr,[Ri]:Ri},f=new Vn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new it},radius:{value:4}},vertexShader:AA,fragmentShader:TA}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let g=new jt;g.setAttribute("position",new en(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Me(g,f),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Er;let m=this.type;this.render=function(A,_,w){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||A.length===0)return;this.type===Km&&(Je("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Er);let U=t.getRenderTarget(),L=t.getActiveCubeFace(),N=t.getActiveMipmapLevel(),k=t.state;k.setBlending(Ds),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let H=m!==this.type;H&&_.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(z=>z.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,z=A.length;I<z;I++){let $=A[I],V=$.shadow;if(V===void 0){Je("WebGLShadowMap:",$,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let ae=V.getFrameExtents();s.multiply(ae),r.copy(V.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ae.x),s.x=r.x*ae.x,V.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ae.y),s.y=r.y*ae.y,V.mapSize.y=r.y));let q=t.state.buffers.depth.getReversed();if(V.camera._reversedDepth=q,V.map===null||H===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===Ro){if($.isPointLight){Je("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new gi(s.x,s.y,{format:Zi,type:Yi,minFilter:si,magFilter:si,generateMipmaps:!1}),V.map.texture.name=$.name+".shadowMap",V.map.depthTexture=new Ps(s.x,s.y,$i),V.map.depthTexture.name=$.name+".shadowMapDepth",V.map.depthTexture.format=Cs,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=kn,V.map.depthTexture.magFilter=kn}else $.isPointLight?(V.map=new il(s.x),V.map.depthTexture=new Ia(s.x,qi)):(V.map=new gi(s.x,s.y),V.map.depthTexture=new Ps(s.x,s.y,qi)),V.map.depthTexture.name=$.name+".shadowMap",V.map.depthTexture.format=Cs,this.type===Er?(V.map.depthTexture.compareFunction=q?Yf:$f,V.map.depthTexture.minFilter=si,V.map.depthTexture.magFilter=si):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=kn,V.map.depthTexture.magFilter=kn);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let K=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();$.isPointLight!==!0&&V.updateMatrices($,w);let ne=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:w.layers;for(let he=0;he<K;he++){let fe=V.getCamera(he);if($.isPointLight){let Q=V.camera,me=V.matrix,xe=$.distance||Q.far;xe!==Q.far&&(Q.far=xe,Q.updateProjectionMatrix()),tl.setFromMatrixPosition($.matrixWorld),Q.position.copy(tl),sd.copy(Q.position),sd.add(CA[he]),Q.up.copy(RA[he]),Q.lookAt(sd),Q.updateMatrixWorld(),me.makeTranslation(-tl.x,-tl.y,-tl.z),s0.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),V._frustum.setFromProjectionMatrix(s0,Q.coordinateSystem,Q.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)t.setRenderTarget(V.map,he),t.clear();else{he===0&&(t.setRenderTarget(V.map),t.clear());let Q=V.getViewport(he);o.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),k.viewport(o)}i=V.getFrustum(he),S(_,w,fe,$,ne,this.type)}V.isPointLightShadow!==!0&&this.type===Ro&&v(V,w),V.needsUpdate=!1}m=this.type,p.needsUpdate=!1,t.setRenderTarget(U,L,N)};function v(A,_){let w=e.update(y);f.defines.VSM_SAMPLES!==A.blurSamples&&(f.defines.VSM_SAMPLES=A.blurSamples,d.defines.VSM_SAMPLES=A.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),A.mapPass===null?A.mapPass=new gi(s.x,s.y,{format:Zi,type:Yi}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),f.uniforms.shadow_pass.value=A.map.depthTexture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,t.setRenderTarget(A.mapPass),t.clear(),t.renderBufferDirect(_,null,w,f,y,null),d.uniforms.shadow_pass.value=A.mapPass.texture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,t.setRenderTarget(A.map),t.clear(),t.renderBufferDirect(_,null,w,d,y,null)}function T(A,_,w,U){let L=null,N=w.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(N!==void 0)L=N;else if(L=w.isPointLight===!0?l:a,t.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let k=L.uuid,H=_.uuid,I=c[k];I===void 0&&(I={},c[k]=I);let z=I[H];z===void 0&&(z=L.clone(),I[H]=z,_.addEventListener("dispose",C)),L=z}if(L.visible=_.visible,L.wireframe=_.wireframe,U===Ro?L.side=_.shadowSide!==null?_.shadowSide:_.side:L.side=_.shadowSide!==null?_.shadowSide:h[_.side],L.alphaMap=_.alphaMap,L.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,L.map=_.map,L.clipShadows=_.clipShadows,L.clippingPlanes=_.clippingPlanes,L.clipIntersection=_.clipIntersection,L.displacementMap=_.displacementMap,L.displacementScale=_.displacementScale,L.displacementBias=_.displacementBias,L.wireframeLinewidth=_.wireframeLinewidth,L.linewidth=_.linewidth,w.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let k=t.properties.get(L);k.light=w}return L}function S(A,_,w,U,L,N){if(A.visible===!1)return;if(A.layers.test(L)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&N===Ro)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,A.matrixWorld);let I=e.update(A),z=A.material;if(Array.isArray(z)){let $=I.groups;for(let V=0,ae=$.length;V<ae;V++){let q=$[V],K=z[q.materialIndex];if(K&&K.visible){let ne=T(A,K,U,N);A.onBeforeShadow(t,A,_,w,I,ne,q),t.renderBufferDirect(w,null,I,ne,A,q),A.onAfterShadow(t,A,_,w,I,ne,q)}}}else if(z.visible){let $=T(A,z,U,N);A.onBeforeShadow(t,A,_,w,I,$,null),t.renderBufferDirect(w,null,I,$,A,null),A.onAfterShadow(t,A,_,w,I,$,null)}}let H=A.children;for(let I=0,z=H.length;I<z;I++)S(H[I],_,w,U,L,N)}function C(A){A.target.removeEventListener("dispose",C);for(let w in c){let U=c[w],L=A.target.uuid;L in U&&(U[L].dispose(),delete U[L])}}}function IA(t,e){function n(){let O=!1,se=new Ht,te=null,Ae=new Ht(0,0,0,0);return{setMask:function(ge){te!==ge&&!O&&(t.colorMask(ge,ge,ge,ge),te=ge)},setLocked:function(ge){O=ge},setClear:function(ge,be,We,Qe,ce){ce===!0&&(ge*=Qe,be*=Qe,We*=Qe),se.set(ge,be,We,Qe),Ae.equals(se)===!1&&(t.clearColor(ge,be,We,Qe),Ae.copy(se))},reset:function(){O=!1,te=null,Ae.set(-1,0,0,0)}}}function i(){let O=!1,se=!1,te=null,Ae=null,ge=null;return{setReversed:function(be){if(se!==be){let We=e.get("EXT_clip_control");be?We.clipControlEXT(We.LOWER_LEFT_EXT,We.ZERO_TO_ONE_EXT):We.clipControlEXT(We.LOWER_LEFT_EXT,We.NEGATIVE_ONE_TO_ONE_EXT),se=be;let Qe=ge;ge=null,this.setClear(Qe)}},getReversed:function(){return se},setTest:function(be){be?we(t.DEPTH_TEST):Xe(t.DEPTH_TEST)},setMask:function(be){te!==be&&!O&&(t.depthMask(be),te=be)},setFunc:function(be){if(se&&(be=Lg[be]),Ae!==be){switch(be){case gc:t.depthFunc(t.NEVER);break;case _c:t.depthFunc(t.ALWAYS);break;case xc:t.depthFunc(t.LESS);break;case xo:t.depthFunc(t.LEQUAL);break;case vc:t.depthFunc(t.EQUAL);break;case yc:t.depthFunc(t.GEQUAL);break;case Sc:t.depthFunc(t.GREATER);break;case Mc:t.depthFunc(t.NOTEQUAL);break;default:t.depthFunc(t.LEQUAL)}Ae=be}},setLocked:function(be){O=be},setClear:function(be){ge!==be&&(ge=be,se&&(be=1-be),t.clearDepth(be))},reset:function(){O=!1,te=null,Ae=null,ge=null,se=!1}}}function s(){let O=!1,se=null,te=null,Ae=null,ge=null,be=null,We=null,Qe=null,ce=null;return{setTest:function(ke){O||(ke?we(t.STENCIL_TEST):Xe(t.STENCIL_TEST))},setMask:function(ke){se!==ke&&!O&&(t.stencilMask(ke),se=ke)},setFunc:function(ke,et,Pe){(te!==ke||Ae!==et||ge!==Pe)&&(t.stencilFunc(ke,et,Pe),te=ke,Ae=et,ge=Pe)},setOp:function(ke,et,Pe){(be!==ke||We!==et||Qe!==Pe)&&(t.stencilOp(ke,et,Pe),be=ke,We=et,Qe=Pe)},setLocked:function(ke){O=ke},setClear:function(ke){ce!==ke&&(t.clearStencil(ke),ce=ke)},reset:function(){O=!1,se=null,te=null,Ae=null,ge=null,be=null,We=null,Qe=null,ce=null}}}let r=new n,o=new i,a=new s,l={},c=new WeakMap,u={},h={},f={},d=new WeakMap,g=[],y=null,p=!1,m=null,v=null,T=null,S=null,C=null,A=null,_=null,w=new $e(0,0,0),U=0,L=!1,N=null,k=null,H=null,I=null,z=null,$=t.getParameter(t.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,ae=0,q=t.getParameter(t.VERSION);q.indexOf("WebGL")!==-1?(ae=parseFloat(/^WebGL (\d)/.exec(q)[1]),V=ae>=1):q.indexOf("OpenGL ES")!==-1&&(ae=parseFloat(/^OpenGL ES (\d)/.exec(q)[1]),V=ae>=2);let K=null,ne={},he=t.getParameter(t.SCISSOR_BOX),fe=t.getParameter(t.VIEWPORT),Q=new Ht().fromArray(he),me=new Ht().fromArray(fe);function xe(O,se,te,Ae){let ge=new Uint8Array(4),be=t.createTexture();t.bindTexture(O,be),t.texParameteri(O,t.TEXTURE_MIN_FILTER,t.NEAREST),t.texParameteri(O,t.TEXTURE_MAG_FILTER,t.NEAREST);for(let We=0;We<te;We++)O===t.TEXTURE_3D||O===t.TEXTURE_2D_ARRAY?t.texImage3D(se,0,t.RGBA,1,1,Ae,0,t.RGBA,t.UNSIGNED_BYTE,ge):t.texImage2D(se+We,0,t.RGBA,1,1,0,t.RGBA,t.UNSIGNED_BYTE,ge);return be}let Re={};Re[t.TEXTURE_2D]=xe(t.TEXTURE_2D,t.TEXTURE_2D,1),Re[t.TEXTURE_CUBE_MAP]=xe(t.TEXTURE_CUBE_MAP,t.TEXTURE_CUBE_MAP_POSITIVE_X,6),Re[t.TEXTURE_2D_ARRAY]=xe(t.TEXTURE_2D_ARRAY,t.TEXTURE_2D_ARRAY,1,1),Re[t.TEXTURE_3D]=xe(t.TEXTURE_3D,t.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),we(t.DEPTH_TEST),o.setFunc(xo),_n(!1),Ut(Cf),we(t.CULL_FACE),Kt(Ds);function we(O){u[O]!==!0&&(t.enable(O),u[O]=!0)}function Xe(O){u[O]!==!1&&(t.disable(O),u[O]=!1)}function at(O,se){return f[O]!==se?(t.bindFramebuffer(O,se),f[O]=se,O===t.DRAW_FRAMEBUFFER&&(f[t.FRAMEBUFFER]=se),O===t.FRAMEBUFFER&&(f[t.DRAW_FRAMEBUFFER]=se),!0):!1}function He(O,se){let te=g,Ae=!1;if(O){te=d.get(se),te===void 0&&(te=[],d.set(se,te));let ge=O.textures;if(te.length!==ge.length||te[0]!==t.COLOR_ATTACHMENT0){for(let be=0,We=ge.length;be<We;be++)te[be]=t.COLOR_ATTACHMENT0+be;te.length=ge.length,Ae=!0}}else te[0]!==t.BACK&&(te[0]=t.BACK,Ae=!0);Ae&&t.drawBuffers(te)}function dt(O){return y!==O?(t.useProgram(O),y=O,!0):!1}let ut={[Ar]:t.FUNC_ADD,[eg]:t.FUNC_SUBTRACT,[tg]:t.FUNC_REVERSE_SUBTRACT};ut[ng]=t.MIN,ut[ig]=t.MAX;let rt={[sg]:t.ZERO,[rg]:t.ONE,[og]:t.SRC_COLOR,[Lf]:t.SRC_ALPHA,[fg]:t.SRC_ALPHA_SATURATE,[ug]:t.DST_COLOR,[lg]:t.DST_ALPHA,[ag]:t.ONE_MINUS_SRC_COLOR,[Nf]:t.ONE_MINUS_SRC_ALPHA,[hg]:t.ONE_MINUS_DST_COLOR,[cg]:t.ONE_MINUS_DST_ALPHA,[dg]:t.CONSTANT_COLOR,[pg]:t.ONE_MINUS_CONSTANT_COLOR,[mg]:t.CONSTANT_ALPHA,[gg]:t.ONE_MINUS_CONSTANT_ALPHA};function Kt(O,se,te,Ae,ge,be,We,Qe,ce,ke){if(O===Ds){p===!0&&(Xe(t.BLEND),p=!1);return}if(p===!1&&(we(t.BLEND),p=!0),O!==Qm){if(O!==m||ke!==L){if((v!==Ar||C!==Ar)&&(t.blendEquation(t.FUNC_ADD),v=Ar,C=Ar),ke)switch(O){case Po:t.blendFuncSeparate(t.ONE,t.ONE_MINUS_SRC_ALPHA,t.ONE,t.ONE_MINUS_SRC_ALPHA);break;case Rf:t.blendFunc(t.ONE,t.ONE);break;case Pf:t.blendFuncSeparate(t.ZERO,t.ONE_MINUS_SRC_COLOR,t.ZERO,t.ONE);break;case If:t.blendFuncSeparate(t.DST_COLOR,t.ONE_MINUS_SRC_ALPHA,t.ZERO,t.ONE);break;default:tt("WebGLState: Invalid blending: ",O);break}else switch(O){case Po:t.blendFuncSeparate(t.SRC_ALPHA,t.ONE_MINUS_SRC_ALPHA,t.ONE,t.ONE_MINUS_SRC_ALPHA);break;case Rf:t.blendFuncSeparate(t.SRC_ALPHA,t.ONE,t.ONE,t.ONE);break;case Pf:tt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case If:tt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:tt("WebGLState: Invalid blending: ",O);break}T=null,S=null,A=null,_=null,w.set(0,0,0),U=0,m=O,L=ke}return}ge=ge||se,be=be||te,We=We||Ae,(se!==v||ge!==C)&&(t.blendEquationSeparate(ut[se],ut[ge]),v=se,C=ge),(te!==T||Ae!==S||be!==A||We!==_)&&(t.blendFuncSeparate(rt[te],rt[Ae],rt[be],rt[We]),T=te,S=Ae,A=be,_=We),(Qe.equals(w)===!1||ce!==U)&&(t.blendColor(Qe.r,Qe.g,Qe.b,ce),w.copy(Qe),U=ce),m=O,L=!1}function Vt(O,se){O.side===Ri?Xe(t.CULL_FACE):we(t.CULL_FACE);let te=O.side===ri;se&&(te=!te),_n(te),O.blending===Po&&O.transparent===!1?Kt(Ds):Kt(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);let Ae=O.stencilWrite;a.setTest(Ae),Ae&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),Mt(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?we(t.SAMPLE_ALPHA_TO_COVERAGE):Xe(t.SAMPLE_ALPHA_TO_COVERAGE)}function _n(O){N!==O&&(O?t.frontFace(t.CW):t.frontFace(t.CCW),N=O)}function Ut(O){O!==jm?(we(t.CULL_FACE),O!==k&&(O===Cf?t.cullFace(t.BACK):O===Jm?t.cullFace(t.FRONT):t.cullFace(t.FRONT_AND_BACK))):Xe(t.CULL_FACE),k=O}function Nn(O){O!==H&&(V&&t.lineWidth(O),H=O)}function Mt(O,se,te){O?(we(t.POLYGON_OFFSET_FILL),(I!==se||z!==te)&&(I=se,z=te,o.getReversed()&&(se=-se,te=-te),t.polygonOffset(se,te))):Xe(t.POLYGON_OFFSET_FILL)}function En(O){O?we(t.SCISSOR_TEST):Xe(t.SCISSOR_TEST)}function rn(O){O===void 0&&(O=t.TEXTURE0+$-1),K!==O&&(t.activeTexture(O),K=O)}function xn(O,se,te){te===void 0&&(K===null?te=t.TEXTURE0+$-1:te=K);let Ae=ne[te];Ae===void 0&&(Ae={type:void 0,texture:void 0},ne[te]=Ae),(Ae.type!==O||Ae.texture!==se)&&(K!==te&&(t.activeTexture(te),K=te),t.bindTexture(O,se||Re[O]),Ae.type=O,Ae.texture=se)}function B(){let O=ne[K];O!==void 0&&O.type!==void 0&&(t.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function Ie(){try{t.compressedTexImage2D(...arguments)}catch(O){tt("WebGLState:",O)}}function je(){try{t.compressedTexImage3D(...arguments)}catch(O){tt("WebGLState:",O)}}function lt(){try{t.texSubImage2D(...arguments)}catch(O){tt("WebGLState:",O)}}function Ee(){try{t.texSubImage3D(...arguments)}catch(O){tt("WebGLState:",O)}}function Ot(){try{t.compressedTexSubImage2D(...arguments)}catch(O){tt("WebGLState:",O)}}function Ve(){try{t.compressedTexSubImage3D(...arguments)}catch(O){tt("WebGLState:",O)}}function Ye(){try{t.texStorage2D(...arguments)}catch(O){tt("WebGLState:",O)}}function R(){try{t.texStorage3D(...arguments)}catch(O){tt("WebGLState:",O)}}function M(){try{t.texImage2D(...arguments)}catch(O){tt("WebGLState:",O)}}function X(){try{t.texImage3D(...arguments)}catch(O){tt("WebGLState:",O)}}function ue(O){return h[O]!==void 0?h[O]:t.getParameter(O)}function re(O,se){h[O]!==se&&(t.pixelStorei(O,se),h[O]=se)}function _e(O){Q.equals(O)===!1&&(t.scissor(O.x,O.y,O.z,O.w),Q.copy(O))}function ve(O){me.equals(O)===!1&&(t.viewport(O.x,O.y,O.z,O.w),me.copy(O))}function ee(O,se){let te=c.get(se);te===void 0&&(te=new WeakMap,c.set(se,te));let Ae=te.get(O);Ae===void 0&&(Ae=t.getUniformBlockIndex(se,O.name),t.uniformBlockBinding(se,Ae,Ae),te.set(O,Ae))}function ie(O,se,te){let ge=c.get(se).get(O);l[ge]!==te&&(t.bindBufferBase(t.UNIFORM_BUFFER,ge,te),l[ge]=te)}function pe(){t.disable(t.BLEND),t.disable(t.CULL_FACE),t.disable(t.DEPTH_TEST),t.disable(t.POLYGON_OFFSET_FILL),t.disable(t.SCISSOR_TEST),t.disable(t.STENCIL_TEST),t.disable(t.SAMPLE_ALPHA_TO_COVERAGE),t.blendEquation(t.FUNC_ADD),t.blendFunc(t.ONE,t.ZERO),t.blendFuncSeparate(t.ONE,t.ZERO,t.ONE,t.ZERO),t.blendColor(0,0,0,0),t.colorMask(!0,!0,!0,!0),t.clearColor(0,0,0,0),t.depthMask(!0),t.depthFunc(t.LESS),o.setReversed(!1),t.clearDepth(1),t.stencilMask(4294967295),t.stencilFunc(t.ALWAYS,0,4294967295),t.stencilOp(t.KEEP,t.KEEP,t.KEEP),t.clearStencil(0),t.cullFace(t.BACK),t.frontFace(t.CCW),t.polygonOffset(0,0),t.activeTexture(t.TEXTURE0),t.bindFramebuffer(t.FRAMEBUFFER,null),t.bindFramebuffer(t.DRAW_FRAMEBUFFER,null),t.bindFramebuffer(t.READ_FRAMEBUFFER,null),t.useProgram(null),t.lineWidth(1),t.scissor(0,0,t.canvas.width,t.canvas.height),t.viewport(0,0,t.canvas.width,t.canvas.height),t.pixelStorei(t.PACK_ALIGNMENT,4),t.pixelStorei(t.UNPACK_ALIGNMENT,4),t.pixelStorei(t.UNPACK_FLIP_Y_WEBGL,!1),t.pixelStorei(t.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),t.pixelStorei(t.UNPACK_COLORSPACE_CONVERSION_WEBGL,t.BROWSER_DEFAULT_WEBGL),t.pixelStorei(t.PACK_ROW_LENGTH,0),t.pixelStorei(t.PACK_SKIP_PIXELS,0),t.pixelStorei(t.PACK_SKIP_ROWS,0),t.pixelStorei(t.UNPACK_ROW_LENGTH,0),t.pixelStorei(t.UNPACK_IMAGE_HEIGHT,0),t.pixelStorei(t.UNPACK_SKIP_PIXELS,0),t.pixelStorei(t.UNPACK_SKIP_ROWS,0),t.pixelStorei(t.UNPACK_SKIP_IMAGES,0),u={},h={},K=null,ne={},f={},l={},d=new WeakMap,g=[],y=null,p=!1,m=null,v=null,T=null,S=null,C=null,A=null,_=null,w=new $e(0,0,0),U=0,L=!1,N=null,k=null,H=null,I=null,z=null,Q.set(0,0,t.canvas.width,t.canvas.height),me.set(0,0,t.canvas.width,t.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:we,disable:Xe,bindFramebuffer:at,drawBuffers:He,useProgram:dt,setBlending:Kt,setMaterial:Vt,setFlipSided:_n,setCullFace:Ut,setLineWidth:Nn,setPolygonOffset:Mt,setScissorTest:En,activeTexture:rn,bindTexture:xn,unbindTexture:B,compressedTexImage2D:Ie,compressedTexImage3D:je,texImage2D:M,texImage3D:X,pixelStorei:re,getParameter:ue,updateUBOMapping:ee,uniformBlockBinding:ie,texStorage2D:Ye,texStorage3D:R,texSubImage2D:lt,texSubImage3D:Ee,compressedTexSubImage2D:Ot,compressedTexSubImage3D:Ve,scissor:_e,viewport:ve,reset:pe}}function LA(t,e,n,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new it,u=new WeakMap,h=new Set,f,d=new WeakMap,g=new Set,y=new FinalizationRegistry(R=>g.delete(R)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(R,M){return p?new OffscreenCanvas(R,M):wa("canvas")}function v(R,M,X){let ue=1,re=Ye(R);if((re.width>X||re.height>X)&&(ue=X/Math.max(re.width,re.height)),ue<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let _e=Math.floor(ue*re.width),ve=Math.floor(ue*re.height);f===void 0&&(f=m(_e,ve));let ee=M?m(_e,ve):f;return ee.width=_e,ee.height=ve,ee.getContext("2d").drawImage(R,0,0,_e,ve),Je("WebGLRenderer: Texture has been resized from ("+re.width+"x"+re.height+") to ("+_e+"x"+ve+")."),ee}else return"data"in R&&Je("WebGLRenderer: Image in DataTexture is too big ("+re.width+"x"+re.height+")."),R;return R}function T(R){return R.generateMipmaps}function S(R){t.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?t.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?t.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?t.TEXTURE_2D_ARRAY:t.TEXTURE_2D}function A(R,M,X,ue,re,_e=!1){if(R!==null){if(t[R]!==void 0)return t[R];Je("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ve;ue&&(ve=e.get("EXT_texture_norm16"),ve||Je("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ee=M;if(M===t.RED&&(X===t.FLOAT&&(ee=t.R32F),X===t.HALF_FLOAT&&(ee=t.R16F),X===t.UNSIGNED_BYTE&&(ee=t.R8),X===t.UNSIGNED_SHORT&&ve&&(ee=ve.R16_EXT),X===t.SHORT&&ve&&(ee=ve.R16_SNORM_EXT)),M===t.RED_INTEGER&&(X===t.UNSIGNED_BYTE&&(ee=t.R8UI),X===t.UNSIGNED_SHORT&&(ee=t.R16UI),X===t.UNSIGNED_INT&&(ee=t.R32UI),X===t.BYTE&&(ee=t.R8I),X===t.SHORT&&(ee=t.R16I),X===t.INT&&(ee=t.R32I)),M===t.RG&&(X===t.FLOAT&&(ee=t.RG32F),X===t.HALF_FLOAT&&(ee=t.RG16F),X===t.UNSIGNED_BYTE&&(ee=t.RG8),X===t.UNSIGNED_SHORT&&ve&&(ee=ve.RG16_EXT),X===t.SHORT&&ve&&(ee=ve.RG16_SNORM_EXT)),M===t.RG_INTEGER&&(X===t.UNSIGNED_BYTE&&(ee=t.RG8UI),X===t.UNSIGNED_SHORT&&(ee=t.RG16UI),X===t.UNSIGNED_INT&&(ee=t.RG32UI),X===t.BYTE&&(ee=t.RG8I),X===t.SHORT&&(ee=t.RG16I),X===t.INT&&(ee=t.RG32I)),M===t.RGB_INTEGER&&(X===t.UNSIGNED_BYTE&&(ee=t.RGB8UI),X===t.UNSIGNED_SHORT&&(ee=t.RGB16UI),X===t.UNSIGNED_INT&&(ee=t.RGB32UI),X===t.BYTE&&(ee=t.RGB8I),X===t.SHORT&&(ee=t.RGB16I),X===t.INT&&(ee=t.RGB32I)),M===t.RGBA_INTEGER&&(X===t.UNSIGNED_BYTE&&(ee=t.RGBA8UI),X===t.UNSIGNED_SHORT&&(ee=t.RGBA16UI),X===t.UNSIGNED_INT&&(ee=t.RGBA32UI),X===t.BYTE&&(ee=t.RGBA8I),X===t.SHORT&&(ee=t.RGBA16I),X===t.INT&&(ee=t.RGBA32I)),M===t.RGB&&(X===t.UNSIGNED_SHORT&&ve&&(ee=ve.RGB16_EXT),X===t.SHORT&&ve&&(ee=ve.RGB16_SNORM_EXT),X===t.UNSIGNED_INT_5_9_9_9_REV&&(ee=t.RGB9_E5),X===t.UNSIGNED_INT_10F_11F_11F_REV&&(ee=t.R11F_G11F_B10F)),M===t.RGBA){let ie=_e?ba:xt.getTransfer(re);X===t.FLOAT&&(ee=t.RGBA32F),X===t.HALF_FLOAT&&(ee=t.RGBA16F),X===t.UNSIGNED_BYTE&&(ee=ie===Rt?t.SRGB8_ALPHA8:t.RGBA8),X===t.UNSIGNED_SHORT&&ve&&(ee=ve.RGBA16_EXT),X===t.SHORT&&ve&&(ee=ve.RGBA16_SNORM_EXT),X===t.UNSIGNED_SHORT_4_4_4_4&&(ee=t.RGBA4),X===t.UNSIGNED_SHORT_5_5_5_1&&(ee=t.RGB5_A1)}return(ee===t.R16F||ee===t.R32F||ee===t.RG16F||ee===t.RG32F||ee===t.RGBA16F||ee===t.RGBA32F)&&e.get("EXT_color_buffer_float"),ee}function _(R,M){let X;return R?M===null||M===qi||M===Cr?X=t.DEPTH24_STENCIL8:M===$i?X=t.DEPTH32F_STENCIL8:M===Lo&&(X=t.DEPTH24_STENCIL8,Je("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===qi||M===Cr?X=t.DEPTH_COMPONENT24:M===$i?X=t.DEPTH_COMPONENT32F:M===Lo&&(X=t.DEPTH_COMPONENT16),X}function w(R,M){return T(R)===!0||R.isFramebufferTexture&&R.minFilter!==kn&&R.minFilter!==si?Math.log2(Math.max(M.width,M.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?M.mipmaps.length:1}function U(R){let M=new WeakRef(R);i.get(R).__ref=M,g.add(M),y.register(R,M,M)}function L(R){let M=i.get(R).__ref;M!==void 0&&(g.delete(M),y.unregister(M))}function N(R){H(R.target)}function k(R){I(R.target)}function H(R){R.removeEventListener("dispose",N),L(R),$(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&h.delete(R)}function I(R){R.removeEventListener("dispose",k),L(R),ae(R)}function z(){for(let R of g){let M=R.deref();M!==void 0&&(M.isRenderTarget===!0?I(M):H(M))}g.clear(),h.clear()}function $(R){let M=i.get(R);if(M.__webglInit===void 0)return;let X=R.source,ue=d.get(X);if(ue){let re=ue[M.__cacheKey];re.usedTimes--,re.usedTimes===0&&V(R),Object.keys(ue).length===0&&d.delete(X)}i.remove(R)}function V(R){let M=i.get(R);t.deleteTexture(M.__webglTexture);let X=R.source,ue=d.get(X);delete ue[M.__cacheKey],o.memory.textures--}function ae(R){let M=i.get(R);M.__depthDisposeCallback&&M.__depthDisposeCallback();let X=R.depthTexture;if(X&&X.renderTarget===R&&H(X),R.isWebGLCubeRenderTarget)for(let re=0;re<6;re++){if(Array.isArray(M.__webglFramebuffer[re]))for(let _e=0;_e<M.__webglFramebuffer[re].length;_e++)t.deleteFramebuffer(M.__webglFramebuffer[re][_e]);else t.deleteFramebuffer(M.__webglFramebuffer[re]);M.__webglDepthbuffer&&t.deleteRenderbuffer(M.__webglDepthbuffer[re])}else{if(Array.isArray(M.__webglFramebuffer))for(let re=0;re<M.__webglFramebuffer.length;re++)t.deleteFramebuffer(M.__webglFramebuffer[re]);else t.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&t.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&t.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let re=0;re<M.__webglColorRenderbuffer.length;re++)M.__webglColorRenderbuffer[re]&&t.deleteRenderbuffer(M.__webglColorRenderbuffer[re]);M.__webglDepthRenderbuffer&&t.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ue=R.textures;for(let re=0,_e=ue.length;re<_e;re++){let ve=i.get(ue[re]);ve.__webglTexture&&(t.deleteTexture(ve.__webglTexture),o.memory.textures--),i.remove(ue[re])}i.remove(R)}let q=0;function K(){q=0}function ne(){return q}function he(R){q=R}function fe(){let R=q;return R>=s.maxTextures&&Je("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),q+=1,R}function Q(R){let M=[];return M.push(R.wrapS),M.push(R.wrapT),M.push(R.wrapR||0),M.push(R.magFilter),M.push(R.minFilter),M.push(R.anisotropy),M.push(R.internalFormat),M.push(R.format),M.push(R.type),M.push(R.generateMipmaps),M.push(R.mipmapsAutoUpdate),M.push(R.premultiplyAlpha),M.push(R.flipY),M.push(R.unpackAlignment),M.push(R.colorSpace),M.join()}function me(R,M){let X=i.get(R);if(R.isVideoTexture&&Ot(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&X.__version!==R.version){let ue=R.image;if(ue===null)Je("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Je("WebGLRenderer: Texture marked for update but image is incomplete");else{Vt(X,R,M);return}}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);n.bindTexture(t.TEXTURE_2D,X.__webglTexture,t.TEXTURE0+M)}function xe(R,M){let X=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){Vt(X,R,M);return}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);n.bindTexture(t.TEXTURE_2D_ARRAY,X.__webglTexture,t.TEXTURE0+M)}function Re(R,M){let X=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){Vt(X,R,M);return}n.bindTexture(t.TEXTURE_3D,X.__webglTexture,t.TEXTURE0+M)}function we(R,M){let X=i.get(R);if(R.version>0&&X.__version!==R.version){_n(X,R,M);return}n.bindTexture(t.TEXTURE_CUBE_MAP,X.__webglTexture,t.TEXTURE0+M)}let Xe={[bc]:t.REPEAT,[cs]:t.CLAMP_TO_EDGE,[wc]:t.MIRRORED_REPEAT},at={[kn]:t.NEAREST,[vg]:t.NEAREST_MIPMAP_NEAREST,[Wa]:t.NEAREST_MIPMAP_LINEAR,[si]:t.LINEAR,[Kc]:t.LINEAR_MIPMAP_NEAREST,[Us]:t.LINEAR_MIPMAP_LINEAR},He={[bg]:t.NEVER,[Zf]:t.ALWAYS,[wg]:t.LESS,[$f]:t.LEQUAL,[Eg]:t.EQUAL,[Yf]:t.GEQUAL,[Ag]:t.GREATER,[Tg]:t.NOTEQUAL};function dt(R,M){if(M.type===$i&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===si||M.magFilter===Kc||M.magFilter===Wa||M.magFilter===Us||M.minFilter===si||M.minFilter===Kc||M.minFilter===Wa||M.minFilter===Us)&&Je("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),t.texParameteri(R,t.TEXTURE_WRAP_S,Xe[M.wrapS]),t.texParameteri(R,t.TEXTURE_WRAP_T,Xe[M.wrapT]),(R===t.TEXTURE_3D||R===t.TEXTURE_2D_ARRAY)&&t.texParameteri(R,t.TEXTURE_WRAP_R,Xe[M.wrapR]),t.texParameteri(R,t.TEXTURE_MAG_FILTER,at[M.magFilter]),t.texParameteri(R,t.TEXTURE_MIN_FILTER,at[M.minFilter]),M.compareFunction&&(t.texParameteri(R,t.TEXTURE_COMPARE_MODE,t.COMPARE_REF_TO_TEXTURE),t.texParameteri(R,t.TEXTURE_COMPARE_FUNC,He[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===kn||M.minFilter!==Wa&&M.minFilter!==Us||M.type===$i&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");t.texParameterf(R,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function ut(R,M){let X=!1;R.__webglInit===void 0&&(R.__webglInit=!0,M.addEventListener("dispose",N),U(M));let ue=M.source,re=d.get(ue);re===void 0&&(re={},d.set(ue,re));let _e=Q(M);if(_e!==R.__cacheKey){re[_e]===void 0&&(re[_e]={texture:t.createTexture(),usedTimes:0},o.memory.textures++,X=!0),re[_e].usedTimes++;let ve=re[R.__cacheKey];ve!==void 0&&(re[R.__cacheKey].usedTimes--,ve.usedTimes===0&&V(M)),R.__cacheKey=_e,R.__webglTexture=re[_e].texture}return X}function rt(R,M,X){return Math.floor(Math.floor(R/X)/M)}function Kt(R,M,X,ue){let _e=R.updateRanges;if(_e.length===0)n.texSubImage2D(t.TEXTURE_2D,0,0,0,M.width,M.height,X,ue,M.data);else{_e.sort((O,se)=>O.start-se.start);let ve=0;for(let O=1;O<_e.length;O++){let se=_e[ve],te=_e[O],Ae=se.start+se.count,ge=rt(te.start,M.width,4),be=rt(se.start,M.width,4);te.start<=Ae+1&&ge===be&&rt(te.start+te.count-1,M.width,4)===ge?se.count=Math.max(se.count,te.start+te.count-se.start):(++ve,_e[ve]=te)}_e.length=ve+1;let ee=n.getParameter(t.UNPACK_ROW_LENGTH),ie=n.getParameter(t.UNPACK_SKIP_PIXELS),pe=n.getParameter(t.UNPACK_SKIP_ROWS);n.pixelStorei(t.UNPACK_ROW_LENGTH,M.width);for(let O=0,se=_e.length;O<se;O++){let te=_e[O],Ae=Math.floor(te.start/4),ge=Math.ceil(te.count/4),be=Ae%M.width,We=Math.floor(Ae/M.width),Qe=ge,ce=1;n.pixelStorei(t.UNPACK_SKIP_PIXELS,be),n.pixelStorei(t.UNPACK_SKIP_ROWS,We),n.texSubImage2D(t.TEXTURE_2D,0,be,We,Qe,ce,X,ue,M.data)}R.clearUpdateRanges(),n.pixelStorei(t.UNPACK_ROW_LENGTH,ee),n.pixelStorei(t.UNPACK_SKIP_PIXELS,ie),n.pixelStorei(t.UNPACK_SKIP_ROWS,pe)}}function Vt(R,M,X){let ue=t.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ue=t.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ue=t.TEXTURE_3D);let re=ut(R,M),_e=M.source;n.bindTexture(ue,R.__webglTexture,t.TEXTURE0+X);let ve=i.get(_e);if(_e.version!==ve.__version||re===!0){if(n.activeTexture(t.TEXTURE0+X),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let ce=xt.getPrimaries(xt.workingColorSpace),ke=M.colorSpace===Os?null:xt.getPrimaries(M.colorSpace),et=M.colorSpace===Os||ce===ke?t.NONE:t.BROWSER_DEFAULT_WEBGL;n.pixelStorei(t.UNPACK_FLIP_Y_WEBGL,M.flipY),n.pixelStorei(t.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),n.pixelStorei(t.UNPACK_COLORSPACE_CONVERSION_WEBGL,et)}n.pixelStorei(t.UNPACK_ALIGNMENT,M.unpackAlignment);let ie=v(M.image,!1,s.maxTextureSize);ie=Ve(M,ie);let pe=r.convert(M.format,M.colorSpace),O=r.convert(M.type),se=A(M.internalFormat,pe,O,M.normalized,M.colorSpace,M.isVideoTexture);dt(ue,M);let te,Ae=M.mipmaps,ge=M.isVideoTexture!==!0,be=ve.__version===void 0||re===!0,We=_e.dataReady,Qe=w(M,ie);if(M.isDepthTexture)se=_(M.format===Fs,M.type),be&&(ge?n.texStorage2D(t.TEXTURE_2D,1,se,ie.width,ie.height):n.texImage2D(t.TEXTURE_2D,0,se,ie.width,ie.height,0,pe,O,null));else if(M.isDataTexture)if(Ae.length>0){ge&&be&&n.texStorage2D(t.TEXTURE_2D,Qe,se,Ae[0].width,Ae[0].height);for(let ce=0,ke=Ae.length;ce<ke;ce++)te=Ae[ce],ge?We&&n.texSubImage2D(t.TEXTURE_2D,ce,0,0,te.width,te.height,pe,O,te.data):n.texImage2D(t.TEXTURE_2D,ce,se,te.width,te.height,0,pe,O,te.data);M.generateMipmaps=!1}else ge?(be&&n.texStorage2D(t.TEXTURE_2D,Qe,se,ie.width,ie.height),We&&Kt(M,ie,pe,O)):n.texImage2D(t.TEXTURE_2D,0,se,ie.width,ie.height,0,pe,O,ie.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){ge&&be&&n.texStorage3D(t.TEXTURE_2D_ARRAY,Qe,se,Ae[0].width,Ae[0].height,ie.depth);for(let ce=0,ke=Ae.length;ce<ke;ce++)if(te=Ae[ce],M.format!==ci)if(pe!==null)if(ge){if(We)if(M.layerUpdates.size>0){let et=nd(te.width,te.height,M.format,M.type);for(let Pe of M.layerUpdates){let ct=te.data.subarray(Pe*et/te.data.BYTES_PER_ELEMENT,(Pe+1)*et/te.data.BYTES_PER_ELEMENT);n.compressedTexSubImage3D(t.TEXTURE_2D_ARRAY,ce,0,0,Pe,te.width,te.height,1,pe,ct)}}else n.compressedTexSubImage3D(t.TEXTURE_2D_ARRAY,ce,0,0,0,te.width,te.height,ie.depth,pe,te.data)}else n.compressedTexImage3D(t.TEXTURE_2D_ARRAY,ce,se,te.width,te.height,ie.depth,0,te.data,0,0);else Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ge?We&&n.texSubImage3D(t.TEXTURE_2D_ARRAY,ce,0,0,0,te.width,te.height,ie.depth,pe,O,te.data):n.texImage3D(t.TEXTURE_2D_ARRAY,ce,se,te.width,te.height,ie.depth,0,pe,O,te.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{ge&&be&&n.texStorage2D(t.TEXTURE_2D,Qe,se,Ae[0].width,Ae[0].height);for(let ce=0,ke=Ae.length;ce<ke;ce++)te=Ae[ce],M.format!==ci?pe!==null?ge?We&&n.compressedTexSubImage2D(t.TEXTURE_2D,ce,0,0,te.width,te.height,pe,te.data):n.compressedTexImage2D(t.TEXTURE_2D,ce,se,te.width,te.height,0,te.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ge?We&&n.texSubImage2D(t.TEXTURE_2D,ce,0,0,te.width,te.height,pe,O,te.data):n.texImage2D(t.TEXTURE_2D,ce,se,te.width,te.height,0,pe,O,te.data)}else if(M.isDataArrayTexture)if(ge){if(be&&n.texStorage3D(t.TEXTURE_2D_ARRAY,Qe,se,ie.width,ie.height,ie.depth),We)if(M.layerUpdates.size>0){let ce=nd(ie.width,ie.height,M.format,M.type);for(let ke of M.layerUpdates){let et=ie.data.subarray(ke*ce/ie.data.BYTES_PER_ELEMENT,(ke+1)*ce/ie.data.BYTES_PER_ELEMENT);n.texSubImage3D(t.TEXTURE_2D_ARRAY,0,0,0,ke,ie.width,ie.height,1,pe,O,et)}M.clearLayerUpdates()}else n.texSubImage3D(t.TEXTURE_2D_ARRAY,0,0,0,0,ie.width,ie.height,ie.depth,pe,O,ie.data)}else n.texImage3D(t.TEXTURE_2D_ARRAY,0,se,ie.width,ie.height,ie.depth,0,pe,O,ie.data);else if(M.isData3DTexture)ge?(be&&n.texStorage3D(t.TEXTURE_3D,Qe,se,ie.width,ie.height,ie.depth),We&&n.texSubImage3D(t.TEXTURE_3D,0,0,0,0,ie.width,ie.height,ie.depth,pe,O,ie.data)):n.texImage3D(t.TEXTURE_3D,0,se,ie.width,ie.height,ie.depth,0,pe,O,ie.data);else if(M.isFramebufferTexture){if(be)if(ge)n.texStorage2D(t.TEXTURE_2D,Qe,se,ie.width,ie.height);else{let ce=ie.width,ke=ie.height;for(let et=0;et<Qe;et++)n.texImage2D(t.TEXTURE_2D,et,se,ce,ke,0,pe,O,null),ce>>=1,ke>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in t){let ce=t.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),ie.parentNode!==ce){ce.appendChild(ie),h.add(M),ce.onpaint=ke=>{let et=ke.changedElements;for(let Pe of h)et.includes(Pe.image)&&(Pe.needsUpdate=!0)},ce.requestPaint();return}if(t.texElementImage2D.length===3)t.texElementImage2D(t.TEXTURE_2D,t.RGBA8,ie);else{let et=t.RGBA,Pe=t.RGBA,ct=t.UNSIGNED_BYTE;t.texElementImage2D(t.TEXTURE_2D,0,et,Pe,ct,ie)}t.texParameteri(t.TEXTURE_2D,t.TEXTURE_MIN_FILTER,t.LINEAR),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_WRAP_S,t.CLAMP_TO_EDGE),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_WRAP_T,t.CLAMP_TO_EDGE)}}else if(Ae.length>0){if(ge&&be){let ce=Ye(Ae[0]);n.texStorage2D(t.TEXTURE_2D,Qe,se,ce.width,ce.height)}for(let ce=0,ke=Ae.length;ce<ke;ce++)te=Ae[ce],ge?We&&n.texSubImage2D(t.TEXTURE_2D,ce,0,0,pe,O,te):n.texImage2D(t.TEXTURE_2D,ce,se,pe,O,te);M.generateMipmaps=!1}else if(ge){if(be){let ce=Ye(ie);n.texStorage2D(t.TEXTURE_2D,Qe,se,ce.width,ce.height)}We&&n.texSubImage2D(t.TEXTURE_2D,0,0,0,pe,O,ie)}else n.texImage2D(t.TEXTURE_2D,0,se,pe,O,ie);T(M)&&M.mipmapsAutoUpdate===!0&&S(ue),ve.__version=_e.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function _n(R,M,X){if(M.image.length!==6)return;let ue=ut(R,M),re=M.source;n.bindTexture(t.TEXTURE_CUBE_MAP,R.__webglTexture,t.TEXTURE0+X);let _e=i.get(re);if(re.version!==_e.__version||ue===!0){n.activeTexture(t.TEXTURE0+X);let ve=xt.getPrimaries(xt.workingColorSpace),ee=M.colorSpace===Os?null:xt.getPrimaries(M.colorSpace),ie=M.colorSpace===Os||ve===ee?t.NONE:t.BROWSER_DEFAULT_WEBGL;n.pixelStorei(t.UNPACK_FLIP_Y_WEBGL,M.flipY),n.pixelStorei(t.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),n.pixelStorei(t.UNPACK_ALIGNMENT,M.unpackAlignment),n.pixelStorei(t.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie);let pe=M.isCompressedTexture||M.image[0].isCompressedTexture,O=M.image[0]&&M.image[0].isDataTexture,se=[];for(let Pe=0;Pe<6;Pe++)!pe&&!O?se[Pe]=v(M.image[Pe],!0,s.maxCubemapSize):se[Pe]=O?M.image[Pe].image:M.image[Pe],se[Pe]=Ve(M,se[Pe]);let te=se[0],Ae=r.convert(M.format,M.colorSpace),ge=r.convert(M.type),be=A(M.internalFormat,Ae,ge,M.normalized,M.colorSpace),We=M.isVideoTexture!==!0,Qe=_e.__version===void 0||ue===!0,ce=re.dataReady,ke=w(M,te);dt(t.TEXTURE_CUBE_MAP,M);let et;if(M.isDepthTexture){if(be=_(M.format===Fs,M.type),Qe)if(We)n.texStorage2D(t.TEXTURE_CUBE_MAP,1,be,te.width,te.height);else for(let Pe=0;Pe<6;Pe++)n.texImage2D(t.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,be,te.width,te.height,0,Ae,ge,null)}else if(pe){We&&Qe&&n.texStorage2D(t.TEXTURE_CUBE_MAP,ke,be,te.width,te.height);for(let Pe=0;Pe<6;Pe++){et=se[Pe].mipmaps;for(let ct=0;ct<et.length;ct++){let Xt=et[ct];M.format!==ci?Ae!==null?We?ce&&n.compressedTexSubImage2D(t.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct,0,0,Xt.width,Xt.height,Ae,Xt.data):n.compressedTexImage2D(t.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct,be,Xt.width,Xt.height,0,Xt.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):We?ce&&n.texSubImage2D(t.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct,0,0,Xt.width,Xt.height,Ae,ge,Xt.data):n.texImage2D(t.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct,be,Xt.width,Xt.height,0,Ae,ge,Xt.data)}}}else{if(et=M.mipmaps,We&&Qe){et.length>0&&ke++;let Pe=Ye(se[0]);n.texStorage2D(t.TEXTURE_CUBE_MAP,ke,be,Pe.width,Pe.height)}for(let Pe=0;Pe<6;Pe++)if(O){We?ce&&n.texSubImage2D(t.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,se[Pe].width,se[Pe].height,Ae,ge,se[Pe].data):n.texImage2D(t.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,be,se[Pe].width,se[Pe].height,0,Ae,ge,se[Pe].data);for(let ct=0;ct<et.length;ct++){let Jn=et[ct].image[Pe].image;We?ce&&n.texSubImage2D(t.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct+1,0,0,Jn.width,Jn.height,Ae,ge,Jn.data):n.texImage2D(t.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct+1,be,Jn.width,Jn.height,0,Ae,ge,Jn.data)}}else{We?ce&&n.texSubImage2D(t.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,Ae,ge,se[Pe]):n.texImage2D(t.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,be,Ae,ge,se[Pe]);for(let ct=0;ct<et.length;ct++){let Xt=et[ct];We?ce&&n.texSubImage2D(t.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct+1,0,0,Ae,ge,Xt.image[Pe]):n.texImage2D(t.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct+1,be,Ae,ge,Xt.image[Pe])}}}T(M)&&M.mipmapsAutoUpdate===!0&&S(t.TEXTURE_CUBE_MAP),_e.__version=re.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function Ut(R,M,X,ue,re,_e){let ve=r.convert(X.format,X.colorSpace),ee=r.convert(X.type),ie=A(X.internalFormat,ve,ee,X.normalized,X.colorSpace),pe=i.get(M),O=i.get(X);if(O.__renderTarget=M,!pe.__hasExternalTextures){let se=Math.max(1,M.width>>_e),te=Math.max(1,M.height>>_e);re===t.TEXTURE_3D||re===t.TEXTURE_2D_ARRAY?n.texImage3D(re,_e,ie,se,te,M.depth,0,ve,ee,null):n.texImage2D(re,_e,ie,se,te,0,ve,ee,null)}n.bindFramebuffer(t.FRAMEBUFFER,R),Ee(M)?a.framebufferTexture2DMultisampleEXT(t.FRAMEBUFFER,ue,re,O.__webglTexture,0,lt(M)):(re===t.TEXTURE_2D||re>=t.TEXTURE_CUBE_MAP_POSITIVE_X&&re<=t.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&t.framebufferTexture2D(t.FRAMEBUFFER,ue,re,O.__webglTexture,_e),n.bindFramebuffer(t.FRAMEBUFFER,null)}function Nn(R,M,X){if(t.bindRenderbuffer(t.RENDERBUFFER,R),M.depthBuffer){let ue=M.depthTexture,re=ue&&ue.isDepthTexture?ue.type:null,_e=_(M.stencilBuffer,re),ve=M.stencilBuffer?t.DEPTH_STENCIL_ATTACHMENT:t.DEPTH_ATTACHMENT;Ee(M)?a.renderbufferStorageMultisampleEXT(t.RENDERBUFFER,lt(M),_e,M.width,M.height):X?t.renderbufferStorageMultisample(t.RENDERBUFFER,lt(M),_e,M.width,M.height):t.renderbufferStorage(t.RENDERBUFFER,_e,M.width,M.height),t.framebufferRenderbuffer(t.FRAMEBUFFER,ve,t.RENDERBUFFER,R)}else{let ue=M.textures;for(let re=0;re<ue.length;re++){let _e=ue[re],ve=r.convert(_e.format,_e.colorSpace),ee=r.convert(_e.type),ie=A(_e.internalFormat,ve,ee,_e.normalized,_e.colorSpace);Ee(M)?a.renderbufferStorageMultisampleEXT(t.RENDERBUFFER,lt(M),ie,M.width,M.height):X?t.renderbufferStorageMultisample(t.RENDERBUFFER,lt(M),ie,M.width,M.height):t.renderbufferStorage(t.RENDERBUFFER,ie,M.width,M.height)}}t.bindRenderbuffer(t.RENDERBUFFER,null)}function Mt(R,M,X){let ue=M.isWebGLCubeRenderTarget===!0;if(n.bindFramebuffer(t.FRAMEBUFFER,R),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let re=i.get(M.depthTexture);re.__renderTarget=M;let _e=ue?M.depthTexture.image[0]:M.depthTexture.image;(!re.__webglTexture||_e.width!==M.width||_e.height!==M.height)&&(_e.width=M.width,_e.height=M.height,M.depthTexture.needsUpdate=!0),ue?we(M.depthTexture,0):me(M.depthTexture,0);let ve=re.__webglTexture,ee=lt(M),ie=ue?t.TEXTURE_CUBE_MAP_POSITIVE_X+X:t.TEXTURE_2D,pe=M.depthTexture.format===Fs?t.DEPTH_STENCIL_ATTACHMENT:t.DEPTH_ATTACHMENT;if(M.depthTexture.format===Cs)Ee(M)?a.framebufferTexture2DMultisampleEXT(t.FRAMEBUFFER,pe,ie,ve,0,ee):t.framebufferTexture2D(t.FRAMEBUFFER,pe,ie,ve,0);else if(M.depthTexture.format===Fs)Ee(M)?a.framebufferTexture2DMultisampleEXT(t.FRAMEBUFFER,pe,ie,ve,0,ee):t.framebufferTexture2D(t.FRAMEBUFFER,pe,ie,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function En(R){let M=i.get(R),X=R.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==R.depthTexture){let ue=R.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ue){let re=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ue.removeEventListener("dispose",re)};ue.addEventListener("dispose",re),M.__depthDisposeCallback=re}M.__boundDepthTexture=ue}if(R.depthTexture&&!M.__autoAllocateDepthBuffer)if(X)for(let ue=0;ue<6;ue++)Mt(M.__webglFramebuffer[ue],R,ue);else R.texture.mipmaps.length>0?Mt(M.__webglFramebuffer[0],R,0):Mt(M.__webglFramebuffer,R,0);else if(X){M.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(n.bindFramebuffer(t.FRAMEBUFFER,M.__webglFramebuffer[ue]),M.__webglDepthbuffer[ue]===void 0)M.__webglDepthbuffer[ue]=t.createRenderbuffer(),Nn(M.__webglDepthbuffer[ue],R,!1);else{let re=R.stencilBuffer?t.DEPTH_STENCIL_ATTACHMENT:t.DEPTH_ATTACHMENT,_e=M.__webglDepthbuffer[ue];t.bindRenderbuffer(t.RENDERBUFFER,_e),t.framebufferRenderbuffer(t.FRAMEBUFFER,re,t.RENDERBUFFER,_e)}}else if(R.texture.mipmaps.length>0?n.bindFramebuffer(t.FRAMEBUFFER,M.__webglFramebuffer[0]):n.bindFramebuffer(t.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=t.createRenderbuffer(),Nn(M.__webglDepthbuffer,R,!1);else{let re=R.stencilBuffer?t.DEPTH_STENCIL_ATTACHMENT:t.DEPTH_ATTACHMENT,_e=M.__webglDepthbuffer;t.bindRenderbuffer(t.RENDERBUFFER,_e),t.framebufferRenderbuffer(t.FRAMEBUFFER,re,t.RENDERBUFFER,_e)}n.bindFramebuffer(t.FRAMEBUFFER,null)}function rn(R,M,X){let ue=i.get(R);M!==void 0&&Ut(ue.__webglFramebuffer,R,R.texture,t.COLOR_ATTACHMENT0,t.TEXTURE_2D,0),X!==void 0&&En(R)}function xn(R){let M=R.texture,X=i.get(R),ue=i.get(M);R.addEventListener("dispose",k),U(R);let re=R.textures,_e=R.isWebGLCubeRenderTarget===!0,ve=re.length>1;if(ve||(ue.__webglTexture===void 0&&(ue.__webglTexture=t.createTexture()),ue.__version=M.version,o.memory.textures++),_e){X.__webglFramebuffer=[];for(let ee=0;ee<6;ee++)if(M.mipmaps.length>0){X.__webglFramebuffer[ee]=[];for(let ie=0;ie<M.mipmaps.length;ie++)X.__webglFramebuffer[ee][ie]=t.createFramebuffer()}else X.__webglFramebuffer[ee]=t.createFramebuffer()}else{if(M.mipmaps.length>0){X.__webglFramebuffer=[];for(let ee=0;ee<M.mipmaps.length;ee++)X.__webglFramebuffer[ee]=t.createFramebuffer()}else X.__webglFramebuffer=t.createFramebuffer();if(ve)for(let ee=0,ie=re.length;ee<ie;ee++){let pe=i.get(re[ee]);pe.__webglTexture===void 0&&(pe.__webglTexture=t.createTexture(),o.memory.textures++)}if(R.samples>0&&Ee(R)===!1){X.__webglMultisampledFramebuffer=t.createFramebuffer(),X.__webglColorRenderbuffer=[],n.bindFramebuffer(t.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let ee=0;ee<re.length;ee++){let ie=re[ee];X.__webglColorRenderbuffer[ee]=t.createRenderbuffer(),t.bindRenderbuffer(t.RENDERBUFFER,X.__webglColorRenderbuffer[ee]);let pe=r.convert(ie.format,ie.colorSpace),O=r.convert(ie.type),se=A(ie.internalFormat,pe,O,ie.normalized,ie.colorSpace,R.isXRRenderTarget===!0),te=lt(R);t.renderbufferStorageMultisample(t.RENDERBUFFER,te,se,R.width,R.height),t.framebufferRenderbuffer(t.FRAMEBUFFER,t.COLOR_ATTACHMENT0+ee,t.RENDERBUFFER,X.__webglColorRenderbuffer[ee])}t.bindRenderbuffer(t.RENDERBUFFER,null),R.depthBuffer&&(X.__webglDepthRenderbuffer=t.createRenderbuffer(),Nn(X.__webglDepthRenderbuffer,R,!0)),n.bindFramebuffer(t.FRAMEBUFFER,null)}}if(_e){n.bindTexture(t.TEXTURE_CUBE_MAP,ue.__webglTexture),dt(t.TEXTURE_CUBE_MAP,M);for(let ee=0;ee<6;ee++)if(M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)Ut(X.__webglFramebuffer[ee][ie],R,M,t.COLOR_ATTACHMENT0,t.TEXTURE_CUBE_MAP_POSITIVE_X+ee,ie);else Ut(X.__webglFramebuffer[ee],R,M,t.COLOR_ATTACHMENT0,t.TEXTURE_CUBE_MAP_POSITIVE_X+ee,0);T(M)?S(t.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&t.texParameteri(t.TEXTURE_CUBE_MAP,t.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),n.unbindTexture()}else if(ve){for(let ee=0,ie=re.length;ee<ie;ee++){let pe=re[ee],O=i.get(pe),se=t.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(se=R.isWebGL3DRenderTarget?t.TEXTURE_3D:t.TEXTURE_2D_ARRAY),n.bindTexture(se,O.__webglTexture),dt(se,pe),Ut(X.__webglFramebuffer,R,pe,t.COLOR_ATTACHMENT0+ee,se,0),T(pe)&&S(se)}n.unbindTexture()}else{let ee=t.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(ee=R.isWebGL3DRenderTarget?t.TEXTURE_3D:t.TEXTURE_2D_ARRAY),n.bindTexture(ee,ue.__webglTexture),dt(ee,M),M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)Ut(X.__webglFramebuffer[ie],R,M,t.COLOR_ATTACHMENT0,ee,ie);else Ut(X.__webglFramebuffer,R,M,t.COLOR_ATTACHMENT0,ee,0);T(M)?S(ee):M.mipmaps.length>0&&t.texParameteri(ee,t.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),n.unbindTexture()}R.depthBuffer&&En(R)}function B(R){let M=R.textures;for(let X=0,ue=M.length;X<ue;X++){let re=M[X];if(T(re)&&re.mipmapsAutoUpdate===!0){let _e=C(R),ve=i.get(re).__webglTexture;n.bindTexture(_e,ve),S(_e),n.unbindTexture()}}}let Ie=[];function je(R){if(R.samples>0){if(Ee(R)===!1){let M=R.textures,X=R.width,ue=R.height,re=t.COLOR_BUFFER_BIT,_e=R.stencilBuffer?t.DEPTH_STENCIL_ATTACHMENT:t.DEPTH_ATTACHMENT,ve=i.get(R),ee=M.length>1;if(ee)for(let pe=0;pe<M.length;pe++)n.bindFramebuffer(t.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),t.framebufferRenderbuffer(t.FRAMEBUFFER,t.COLOR_ATTACHMENT0+pe,t.RENDERBUFFER,null),n.bindFramebuffer(t.FRAMEBUFFER,ve.__webglFramebuffer),t.framebufferTexture2D(t.DRAW_FRAMEBUFFER,t.COLOR_ATTACHMENT0+pe,t.TEXTURE_2D,null,0);n.bindFramebuffer(t.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?n.bindFramebuffer(t.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):n.bindFramebuffer(t.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let pe=0;pe<M.length;pe++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(re|=t.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(re|=t.STENCIL_BUFFER_BIT)),ee){t.framebufferRenderbuffer(t.READ_FRAMEBUFFER,t.COLOR_ATTACHMENT0,t.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let O=i.get(M[pe]).__webglTexture;t.framebufferTexture2D(t.DRAW_FRAMEBUFFER,t.COLOR_ATTACHMENT0,t.TEXTURE_2D,O,0)}t.blitFramebuffer(0,0,X,ue,0,0,X,ue,re,t.NEAREST),l===!0&&(Ie.length=0,Ie.push(t.COLOR_ATTACHMENT0+pe),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Ie.push(_e),t.invalidateFramebuffer(t.READ_FRAMEBUFFER,Ie))}if(n.bindFramebuffer(t.READ_FRAMEBUFFER,null),n.bindFramebuffer(t.DRAW_FRAMEBUFFER,null),ee)for(let pe=0;pe<M.length;pe++){n.bindFramebuffer(t.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),t.framebufferRenderbuffer(t.FRAMEBUFFER,t.COLOR_ATTACHMENT0+pe,t.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let O=i.get(M[pe]).__webglTexture;n.bindFramebuffer(t.FRAMEBUFFER,ve.__webglFramebuffer),t.framebufferTexture2D(t.DRAW_FRAMEBUFFER,t.COLOR_ATTACHMENT0+pe,t.TEXTURE_2D,O,0)}n.bindFramebuffer(t.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let M=R.stencilBuffer?t.DEPTH_STENCIL_ATTACHMENT:t.DEPTH_ATTACHMENT;t.invalidateFramebuffer(t.DRAW_FRAMEBUFFER,[M])}}}function lt(R){return Math.min(s.maxSamples,R.samples)}function Ee(R){let M=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Ot(R){let M=o.render.frame;u.get(R)!==M&&(u.set(R,M),R.update())}function Ve(R,M){let X=R.colorSpace,ue=R.format,re=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||X!==Ma&&X!==Os&&(xt.getTransfer(X)===Rt?(ue!==ci||re!==$n)&&Je("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):tt("WebGLTextures: Unsupported texture color space:",X)),M}function Ye(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=fe,this.resetTextureUnits=K,this.getTextureUnits=ne,this.setTextureUnits=he,this.setTexture2D=me,this.setTexture2DArray=xe,this.setTexture3D=Re,this.setTextureCube=we,this.rebindTextures=rn,this.setupRenderTarget=xn,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=je,this.setupDepthRenderbuffer=En,this.setupFrameBufferTexture=Ut,this.useMultisampledRTT=Ee,this.dispose=z}function NA(t,e){function n(i,s=Os){let r,o=xt.getTransfer(s);if(i===$n)return t.UNSIGNED_BYTE;if(i===eu)return t.UNSIGNED_SHORT_4_4_4_4;if(i===tu)return t.UNSIGNED_SHORT_5_5_5_1;if(i===Hf)return t.UNSIGNED_INT_5_9_9_9_REV;if(i===Wf)return t.UNSIGNED_INT_10F_11F_11F_REV;if(i===Gf)return t.BYTE;if(i===Vf)return t.SHORT;if(i===Lo)return t.UNSIGNED_SHORT;if(i===Qc)return t.INT;if(i===qi)return t.UNSIGNED_INT;if(i===$i)return t.FLOAT;if(i===Yi)return t.HALF_FLOAT;if(i===Xf)return t.ALPHA;if(i===qf)return t.RGB;if(i===ci)return t.RGBA;if(i===Cs)return t.DEPTH_COMPONENT;if(i===Fs)return t.DEPTH_STENCIL;if(i===Xa)return t.RED;if(i===nu)return t.RED_INTEGER;if(i===Zi)return t.RG;if(i===iu)return t.RG_INTEGER;if(i===su)return t.RGBA_INTEGER;if(i===qa||i===$a||i===Ya||i===Za)if(o===Rt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===qa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===$a)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Ya)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Za)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===qa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===$a)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Ya)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Za)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===ru||i===ou||i===au||i===lu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===ru)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===ou)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===au)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===lu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===cu||i===uu||i===hu||i===fu||i===du||i===ja||i===pu)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===cu||i===uu)return o===Rt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===hu)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===fu)return r.COMPRESSED_R11_EAC;if(i===du)return r.COMPRESSED_SIGNED_R11_EAC;if(i===ja)return r.COMPRESSED_RG11_EAC;if(i===pu)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===mu||i===gu||i===_u||i===xu||i===vu||i===yu||i===Su||i===Mu||i===bu||i===wu||i===Eu||i===Au||i===Tu||i===Cu)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===mu)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===gu)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===_u)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===xu)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===vu)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===yu)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Su)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Mu)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===bu)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===wu)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Eu)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Au)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Tu)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Cu)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Ru||i===Pu||i===Iu)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Ru)return o===Rt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Pu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Iu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Lu||i===Nu||i===Ja||i===Du)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Lu)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Nu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ja)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Du)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Cr?t.UNSIGNED_INT_24_8:t[i]!==void 0?t[i]:null}return{convert:n}}var DA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,UA=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,hd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,n){if(this.texture===null){let i=new La(e.texture);(e.depthNear!==n.depthNear||e.depthFar!==n.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let n=e.cameras[0].viewport,i=new Vn({vertexShader:DA,fragmentShader:UA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:n.z},depthHeight:{value:n.w}}});this.mesh=new Me(new Ls(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},fd=class extends Vi{constructor(e,n){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,g=null,y=typeof XRWebGLBinding<"u",p=new hd,m={},v=n.getContextAttributes(),T=null,S=null,C=[],A=[],_=new it,w=null,U=null,L=new ii;L.viewport=new Ht;let N=new ii;N.viewport=new Ht;let k=[L,N],H=new Yc,I=null,z=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let me=C[Q];return me===void 0&&(me=new bo,C[Q]=me),me.getTargetRaySpace()},this.getControllerGrip=function(Q){let me=C[Q];return me===void 0&&(me=new bo,C[Q]=me),me.getGripSpace()},this.getHand=function(Q){let me=C[Q];return me===void 0&&(me=new bo,C[Q]=me),me.getHandSpace()};function $(Q){let me=A.indexOf(Q.inputSource);if(me===-1)return;let xe=C[me];xe!==void 0&&(xe.update(Q.inputSource,Q.frame,c||o),xe.dispatchEvent({type:Q.type,data:Q.inputSource}))}function V(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",ae);for(let Q=0;Q<C.length;Q++){let me=A[Q];me!==null&&(A[Q]=null,C[Q].disconnect(me))}I=null,z=null,p.reset();for(let Q in m)delete m[Q];if(e.setRenderTarget(T),d=null,f=null,h=null,s=null,S=null,fe.stop(),i.isPresenting=!1,e.setPixelRatio(w),e.setSize(_.width,_.height,!1),U!==null){let Q=U.camera;Q.fov=U.fov,Q.zoom=U.zoom,Q.updateProjectionMatrix(),U=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,i.isPresenting===!0&&Je("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,i.isPresenting===!0&&Je("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h===null&&y&&(h=new XRWebGLBinding(s,n)),h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(T=e.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",V),s.addEventListener("inputsourceschange",ae),v.xrCompatible!==!0&&await n.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let xe=null,Re=null,we=null;v.depth&&(we=v.stencil?n.DEPTH24_STENCIL8:n.DEPTH_COMPONENT24,xe=v.stencil?Fs:Cs,Re=v.stencil?Cr:qi);let Xe={colorFormat:n.RGBA8,depthFormat:we,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(Xe),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),S=new gi(f.textureWidth,f.textureHeight,{format:ci,type:$n,depthTexture:new Ps(f.textureWidth,f.textureHeight,Re,void 0,void 0,void 0,void 0,void 0,void 0,xe),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let xe={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,n,xe),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),S=new gi(d.framebufferWidth,d.framebufferHeight,{format:ci,type:$n,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),fe.setContext(s),fe.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function ae(Q){for(let me=0;me<Q.removed.length;me++){let xe=Q.removed[me],Re=A.indexOf(xe);Re>=0&&(A[Re]=null,C[Re].disconnect(xe))}for(let me=0;me<Q.added.length;me++){let xe=Q.added[me],Re=A.indexOf(xe);if(Re===-1){for(let Xe=0;Xe<C.length;Xe++)if(Xe>=A.length){A.push(xe),Re=Xe;break}else if(A[Xe]===null){A[Xe]=xe,Re=Xe;break}if(Re===-1)break}let we=C[Re];we&&we.connect(xe)}}function q(Q,me){me===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(me.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let me=Q.near,xe=Q.far;p.texture!==null&&(p.depthNear>0&&(me=p.depthNear),p.depthFar>0&&(xe=p.depthFar)),H.near=N.near=L.near=me,H.far=N.far=L.far=xe,(I!==H.near||z!==H.far)&&(s.updateRenderState({depthNear:H.near,depthFar:H.far}),I=H.near,z=H.far),H.layers.mask=Q.layers.mask|6,L.layers.mask=H.layers.mask&-5,N.layers.mask=H.layers.mask&-3;let Re=Q.parent,we=H.cameras;q(H,Re);for(let Xe=0;Xe<we.length;Xe++)q(we[Xe],Re);H.projectionMatrix.copy(L.projectionMatrix),H.projectionMatrixInverse.copy(L.projectionMatrixInverse),U===null&&Q.isPerspectiveCamera&&(U={camera:Q,fov:Q.fov,zoom:Q.zoom}),K(Q,H,Re)};function K(Q,me,xe){xe===null?Q.matrix.copy(me.matrixWorld):(Q.matrix.copy(xe.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(me.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(me.projectionMatrix),Q.projectionMatrixInverse.copy(me.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Ac*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(Q){l=Q,f!==null&&(f.fixedFoveation=Q),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=Q)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(H)},this.getCameraTexture=function(Q){return m[Q]};let ne=null;function he(Q,me){if(u=me.getViewerPose(c||o),g=me,u!==null){let xe=u.views;d!==null&&(e.setRenderTargetFramebuffer(S,d.framebuffer),e.setRenderTarget(S));let Re=!1;xe.length!==H.cameras.length&&(H.cameras.length=0,Re=!0);for(let He=0;He<xe.length;He++){let dt=xe[He],ut=null;if(d!==null)ut=d.getViewport(dt);else{let Kt=h.getViewSubImage(f,dt);ut=Kt.viewport,He===0&&(e.setRenderTargetTextures(S,Kt.colorTexture,Kt.depthStencilTexture),e.setRenderTarget(S))}let rt=k[He];rt===void 0&&(rt=new ii,rt.layers.enable(He),rt.viewport=new Ht,k[He]=rt),rt.matrix.fromArray(dt.transform.matrix),rt.matrix.decompose(rt.position,rt.quaternion,rt.scale),rt.projectionMatrix.fromArray(dt.projectionMatrix),rt.projectionMatrixInverse.copy(rt.projectionMatrix).invert(),rt.viewport.set(ut.x,ut.y,ut.width,ut.height),He===0&&(H.matrix.copy(rt.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),Re===!0&&H.cameras.push(rt)}let we=s.enabledFeatures;if(we&&we.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){h=i.getBinding();let He=h.getDepthInformation(xe[0]);He&&He.isValid&&He.texture&&p.init(He,s.renderState)}if(we&&we.includes("camera-access")&&y){e.state.unbindTexture(),h=i.getBinding();for(let He=0;He<xe.length;He++){let dt=xe[He].camera;if(dt){let ut=m[dt];ut||(ut=new La,m[dt]=ut);let rt=h.getCameraImage(dt);ut.sourceTexture=rt}}}}for(let xe=0;xe<C.length;xe++){let Re=A[xe],we=C[xe];Re!==null&&we!==void 0&&we.update(Re,me,c||o)}ne&&ne(Q,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),g=null}let fe=new r0;fe.setAnimationLoop(he),this.setAnimationLoop=function(Q){ne=Q},this.dispose=function(){}}},FA=new Dt,m0=new st;m0.set(-1,0,0,0,1,0,0,0,1);function OA(t,e){function n(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function i(p,m){m.color.getRGB(p.fogColor.value,Qf(t)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function s(p,m,v,T,S){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),h(p,m)):m.isMeshPhongMaterial?(r(p,m),u(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),f(p,m),m.isMeshPhysicalMaterial&&d(p,m,S)):m.isMeshMatcapMaterial?(r(p,m),g(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),y(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(o(p,m),m.isLineDashedMaterial&&a(p,m)):m.isPointsMaterial?l(p,m,v,T):m.isSpriteMaterial?c(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,n(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,n(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,n(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===ri&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,n(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===ri&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,n(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,n(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,n(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let v=e.get(m),T=v.envMap,S=v.envMapRotation;T&&(p.envMap.value=T,p.envMapRotation.value.setFromMatrix4(FA.makeRotationFromEuler(S)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(m0),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,n(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,n(m.aoMap,p.aoMapTransform))}function o(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,n(m.map,p.mapTransform))}function a(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function l(p,m,v,T){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*v,p.scale.value=T*.5,m.map&&(p.map.value=m.map,n(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,n(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function c(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,n(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,n(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function u(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function h(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function f(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,n(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,n(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function d(p,m,v){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,n(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,n(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,n(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,n(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,n(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,n(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===ri&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,n(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,n(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=v.texture,p.transmissionSamplerSize.value.set(v.width,v.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,n(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,n(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,n(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,n(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,n(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function y(p,m){let v=e.get(m).light;p.referencePosition.value.setFromMatrixPosition(v.matrixWorld),p.nearDistance.value=v.shadow.camera.near,p.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function BA(t,e,n,i){let s={},r={};function o(v,T){let S=T.program;i.uniformBlockBinding(v,S,s[v.id])}function a(v,T){let S=s[v.id];S===void 0&&(g(v),S=l(v),s[v.id]=S,v.addEventListener("dispose",p));let C=T.program;i.updateUBOMapping(v,C);let A=e.render.frame;r[v.id]!==A&&(c(v),r[v.id]=A)}function l(v){let T=t.createBuffer(),S=v.__size,C=v.usage;return t.bindBuffer(t.UNIFORM_BUFFER,T),t.bufferData(t.UNIFORM_BUFFER,S,C),t.bindBuffer(t.UNIFORM_BUFFER,null),T}function c(v){let T=s[v.id],S=v.uniforms,C=v.__cache;t.bindBuffer(t.UNIFORM_BUFFER,T);for(let A=0,_=S.length;A<_;A++){let w=S[A];if(Array.isArray(w))for(let U=0,L=w.length;U<L;U++)u(w[U],A,U,C);else u(w,A,0,C)}t.bindBuffer(t.UNIFORM_BUFFER,null)}function u(v,T,S,C){if(f(v,T,S,C)===!0){let A=v.__offset,_=v.value;if(Array.isArray(_)){let w=0;for(let U=0;U<_.length;U++){let L=_[U],N=y(L,!0);h(L,v.__data,w),w+=N.storage/Float32Array.BYTES_PER_ELEMENT}}else h(_,v.__data,0);t.bufferSubData(t.UNIFORM_BUFFER,A,v.__data)}}function h(v,T,S){typeof v=="number"||typeof v=="boolean"?T[S]=v:v.isMatrix3?(T[S]=v.elements[0],T[S+1]=v.elements[1],T[S+2]=v.elements[2],T[S+3]=0,T[S+4]=v.elements[3],T[S+5]=v.elements[4],T[S+6]=v.elements[5],T[S+7]=0,T[S+8]=v.elements[6],T[S+9]=v.elements[7],T[S+10]=v.elements[8],T[S+11]=0):ArrayBuffer.isView(v)?T.set(v.subarray(0,T.length-S),S):v.toArray(T,S)}function f(v,T,S,C){let A=v.value,_=T+"_"+S;if(Array.isArray(A)){C[_]===void 0&&(C[_]=[]);let w=C[_],U=!1;for(let L=0;L<A.length;L++)d(A[L],w,L)===!0&&(U=!0);return U}return d(A,C,_)}function d(v,T,S){if(T[S]===void 0)return typeof v=="number"||typeof v=="boolean"?T[S]=v:ArrayBuffer.isView(v)?T[S]=v.slice():T[S]=v.clone(),!0;{let C=T[S];if(typeof v=="number"||typeof v=="boolean"){if(C!==v)return T[S]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(C.equals(v)===!1)return C.copy(v),!0}}return!1}function g(v){let T=v.uniforms,S=0,C=16;for(let _=0,w=T.length;_<w;_++){let U=Array.isArray(T[_])?T[_]:[T[_]];for(let L=0,N=U.length;L<N;L++){let k=U[L],H=Array.isArray(k.value)?k.value:[k.value],I=Array.isArray(T[_])||Array.isArray(k.value),z=S;for(let V=0,ae=H.length;V<ae;V++){let q=H[V],K=y(q,I),ne=S%C,he=ne%K.boundary,fe=ne+he;S+=he,fe!==0&&C-fe<K.storage&&(S+=C-fe),V===0&&(z=S),S+=K.storage}let $=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new $((S-z)/Float32Array.BYTES_PER_ELEMENT),k.__offset=z}}let A=S%C;return A>0&&(S+=C-A),v.__size=S,v.__cache={},this}function y(v,T){let S={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(S.boundary=4,S.storage=4):v.isVector2?(S.boundary=8,S.storage=8):v.isVector3||v.isColor?(S.boundary=16,S.storage=12):v.isVector4?(S.boundary=16,S.storage=16):v.isMatrix3?(S.boundary=16,S.storage=48):v.isMatrix4?(S.boundary=16,S.storage=64):v.isTexture?Je("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(S.boundary=16,S.storage=v.byteLength):Je("WebGLRenderer: Unsupported uniform value type.",v),T===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function p(v){let T=v.target;T.removeEventListener("dispose",p),t.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function m(){for(let v in s)t.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:m}}var kA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),fs=null;function zA(){return fs===null&&(fs=new Eo(kA,16,16,Zi,Yi),fs.name="DFG_LUT",fs.minFilter=si,fs.magFilter=si,fs.wrapS=cs,fs.wrapT=cs,fs.generateMipmaps=!1,fs.needsUpdate=!0),fs}var Bu=class{constructor(e={}){let{canvas:n=Rg(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1,outputBufferType:d=$n}=e;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let y=d,p=new Set([su,iu,nu]),m=new Set([$n,qi,Lo,Cr,eu,tu]),v=new Uint32Array(4),T=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},C=null,A=null,_=[],w=[],U=null;this.domElement=n,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=hs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,N=!1,k=null,H=null,I=null,z=null;this._outputColorSpace=ni;let $=0,V=0,ae=null,q=-1,K=null,ne=new Ht,he=new Ht,fe=null,Q=new $e(0),me=0,xe=n.width,Re=n.height,we=1,Xe=null,at=null,He=new Ht(0,0,xe,Re),dt=new Ht(0,0,xe,Re),ut=!1,rt=new nr,Kt=new Pc,Vt=!1,_n=!1,Ut=new Dt,Nn=new F,Mt=new Ht,En={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},rn=!1;function xn(){return ae===null?we:1}let B=i;function Ie(E,G){return n.getContext(E,G)}let je,lt,Ee,Ot,Ve,Ye,R,M,X,ue,re,_e,ve,ee,ie,pe,O,se,te,Ae,ge,be,We;try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in n&&n.setAttribute("data-engine",`three.js r${"187"}`),n.addEventListener("webglcontextlost",ke,!1),n.addEventListener("webglcontextrestored",et,!1),n.addEventListener("webglcontextcreationerror",Pe,!1),B===null){let G="webgl2";if(B=Ie(G,E),B===null)throw Ie(G)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Qe()}catch(E){throw n.removeEventListener("webglcontextlost",ke,!1),n.removeEventListener("webglcontextrestored",et,!1),n.removeEventListener("webglcontextcreationerror",Pe,!1),tt("WebGLRenderer: "+E.message),E}function Qe(){je=new J1(B),je.init(),ge=new NA(B,je),lt=new z1(B,je,e,ge),Ee=new IA(B,je),lt.reversedDepthBuffer&&f&&Ee.buffers.depth.setReversed(!0),H=B.createFramebuffer(),I=B.createFramebuffer(),z=B.createFramebuffer(),Ot=new eE(B),Ve=new _A,Ye=new LA(B,je,Ee,Ve,lt,ge,Ot),R=new j1(L),M=new nb(B),be=new B1(B,M),X=new K1(B,M,Ot,be),ue=new nE(B,X,M,be,Ot),se=new tE(B,lt,Ye),ie=new G1(Ve),re=new gA(L,R,je,lt,be,ie),_e=new OA(L,Ve),ve=new vA,ee=new EA(je),O=new O1(L,R,Ee,ue,g,l),pe=new PA(L,ue,lt),We=new BA(B,Ot,lt,Ee),te=new k1(B,je,Ot),Ae=new Q1(B,je,Ot),Ot.programs=re.programs,L.capabilities=lt,L.extensions=je,L.properties=Ve,L.renderLists=ve,L.shadowMap=pe,L.state=Ee,L.info=Ot}y!==$n&&(U=new sE(y,n.width,n.height,a,s,r));let ce=new fd(L,B);this.xr=ce,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let E=je.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=je.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return we},this.setPixelRatio=function(E){E!==void 0&&(we=E,this.setSize(xe,Re,!1))},this.getSize=function(E){return E.set(xe,Re)},this.setSize=function(E,G,J=!0){if(ce.isPresenting){Je("WebGLRenderer: Can't change size while VR device is presenting.");return}xe=E,Re=G,n.width=Math.floor(E*we),n.height=Math.floor(G*we),J===!0&&(n.style.width=E+"px",n.style.height=G+"px"),U!==null&&U.setSize(n.width,n.height),this.setViewport(0,0,E,G)},this.getDrawingBufferSize=function(E){return E.set(xe*we,Re*we).floor()},this.setDrawingBufferSize=function(E,G,J){xe=E,Re=G,we=J,n.width=Math.floor(E*J),n.height=Math.floor(G*J),this.setViewport(0,0,E,G)},this.setEffects=function(E){if(y===$n){tt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let G=0;G<E.length;G++)if(E[G].isOutputPass===!0){Je("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(ne)},this.getViewport=function(E){return E.copy(He)},this.setViewport=function(E,G,J,Y){E.isVector4?He.set(E.x,E.y,E.z,E.w):He.set(E,G,J,Y),Ee.viewport(ne.copy(He).multiplyScalar(xn()).round())},this.getScissor=function(E){return E.copy(dt)},this.setScissor=function(E,G,J,Y){E.isVector4?dt.set(E.x,E.y,E.z,E.w):dt.set(E,G,J,Y),Ee.scissor(he.copy(dt).multiplyScalar(xn()).round())},this.getScissorTest=function(){return ut},this.setScissorTest=function(E){Ee.setScissorTest(ut=E)},this.setOpaqueSort=function(E){Xe=E},this.setTransparentSort=function(E){at=E},this.getClearColor=function(E){return E.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(E=!0,G=!0,J=!0){let Y=0;if(E){let Z=!1;if(ae!==null){let Te=ae.texture.format;Z=p.has(Te)}if(Z){let Te=ae.texture.type,Le=m.has(Te),Ce=O.getClearColor(),Ne=O.getClearAlpha(),Ge=Ce.r,nt=Ce.g,pt=Ce.b;Le?(v[0]=Ge,v[1]=nt,v[2]=pt,v[3]=Ne,B.clearBufferuiv(B.COLOR,0,v)):(T[0]=Ge,T[1]=nt,T[2]=pt,T[3]=Ne,B.clearBufferiv(B.COLOR,0,T))}else Y|=B.COLOR_BUFFER_BIT}G&&(Y|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),J&&(Y|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&B.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),k=E},this.dispose=function(){n.removeEventListener("webglcontextlost",ke,!1),n.removeEventListener("webglcontextrestored",et,!1),n.removeEventListener("webglcontextcreationerror",Pe,!1),O.dispose(),ve.dispose(),ee.dispose(),Ye.dispose(),Ve.dispose(),R.dispose(),ue.dispose(),X.dispose(),be.dispose(),We.dispose(),re.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",Vl),ce.removeEventListener("sessionend",ts),_s.stop()};function ke(E){E.preventDefault(),Jf("WebGLRenderer: Context Lost."),N=!0}function et(){Jf("WebGLRenderer: Context Restored."),N=!1;let E=Ot.autoReset,G=pe.enabled,J=pe.autoUpdate,Y=pe.needsUpdate,Z=pe.type;Qe(),Ot.autoReset=E,pe.enabled=G,pe.autoUpdate=J,pe.needsUpdate=Y,pe.type=Z}function Pe(E){tt("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function ct(E){let G=E.target;G.removeEventListener("dispose",ct),Xt(G)}function Xt(E){Jn(E),Ve.remove(E)}function Jn(E){let G=Ve.get(E).programs;G!==void 0&&(G.forEach(function(J){re.releaseProgram(J)}),E.isShaderMaterial&&re.releaseShaderCache(E))}this.renderBufferDirect=function(E,G,J,Y,Z,Te){G===null&&(G=En);let Le=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Ce=ua(E,G,J,Y,Z);Ee.setMaterial(Y,Le);let Ne=J.index,Ge=1;if(Y.wireframe===!0){if(Ne=X.getWireframeAttribute(J),Ne===void 0)return;Ge=2}let nt=J.drawRange,pt=J.attributes.position,ze=nt.start*Ge,mt=(nt.start+nt.count)*Ge;Te!==null&&(ze=Math.max(ze,Te.start*Ge),mt=Math.min(mt,(Te.start+Te.count)*Ge)),Ne!==null?(ze=Math.max(ze,0),mt=Math.min(mt,Ne.count)):pt!=null&&(ze=Math.max(ze,0),mt=Math.min(mt,pt.count));let sn=mt-ze;if(sn<0||sn===1/0)return;be.setup(Z,Y,Ce,J,Ne);let It,Lt=te;if(Ne!==null&&(It=M.get(Ne),Lt=Ae,Lt.setIndex(It)),Z.isMesh)Y.wireframe===!0?(Ee.setLineWidth(Y.wireframeLinewidth*xn()),Lt.setMode(B.LINES)):Lt.setMode(B.TRIANGLES);else if(Z.isLine){let An=Y.linewidth;An===void 0&&(An=1),Ee.setLineWidth(An*xn()),Z.isLineSegments?Lt.setMode(B.LINES):Z.isLineLoop?Lt.setMode(B.LINE_LOOP):Lt.setMode(B.LINE_STRIP)}else Z.isPoints?Lt.setMode(B.POINTS):Z.isSprite&&Lt.setMode(B.TRIANGLES);if(Z.isBatchedMesh)if(je.get("WEBGL_multi_draw"))Lt.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let An=Z._multiDrawStarts,Oe=Z._multiDrawCounts,vn=Z._multiDrawCount,_t=Ne?M.get(Ne).bytesPerElement:1,vs=Ve.get(Y).currentProgram.getUniforms();for(let yn=0;yn<vn;yn++)vs.setValue(B,"_gl_DrawID",yn),Lt.render(An[yn]/_t,Oe[yn])}else if(Z.isInstancedMesh)Lt.renderInstances(ze,sn,Z.count);else if(J.isInstancedBufferGeometry){let An=J._maxInstanceCount!==void 0?J._maxInstanceCount:1/0,Oe=Math.min(J.instanceCount,An);Lt.renderInstances(ze,sn,Oe)}else Lt.render(ze,sn)};function aa(E,G,J,Y){k!==null&&E.isNodeMaterial&&k.setObject(Y,E),Vt===!0&&ie.setState(E,J,!1),E.transparent===!0&&E.side===Ri&&E.forceSinglePass===!1?(E.side=ri,E.needsUpdate=!0,ns(E,G,Y),E.side=lr,E.needsUpdate=!0,ns(E,G,Y),E.side=Ri):ns(E,G,Y)}this.compile=function(E,G,J=null){J===null&&(J=E),k!==null&&k.renderStart(E,G,J),A=ee.get(J),A.init(G),w.push(A),J.traverseVisible(function(Z){Z.isLight&&Z.layers.test(G.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),E!==J&&E.traverseVisible(function(Z){Z.isLight&&Z.layers.test(G.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),A.setupLights(),k!==null&&k.updateLights(A.state.lightsArray),_n=this.localClippingEnabled,Vt=ie.init(this.clippingPlanes,_n),Vt===!0&&ie.setGlobalState(this.clippingPlanes,G),k!==null&&pe.render(A.state.shadowsArray,J,G);let Y=new Set;return E.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Te=Z.material;if(Te)if(Array.isArray(Te))for(let Le=0;Le<Te.length;Le++){let Ce=Te[Le];aa(Ce,J,G,Z),Y.add(Ce)}else aa(Te,J,G,Z),Y.add(Te)}),A=w.pop(),k!==null&&k.renderEnd(),Y},this.compileAsync=function(E,G,J=null){let Y=this.compile(E,G,J);return new Promise(Z=>{function Te(){if(Y.forEach(function(Le){let Ne=Ve.get(Le).currentProgram;(Ne===void 0||Ne.isReady())&&Y.delete(Le)}),Y.size===0){Z(E);return}setTimeout(Te,10)}je.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let qr=null;function zh(E){qr&&qr(E)}function Vl(){_s.stop()}function ts(){_s.start()}let _s=new r0;_s.setAnimationLoop(zh),typeof self<"u"&&_s.setContext(self),this.setAnimationLoop=function(E){qr=E,ce.setAnimationLoop(E),E===null?_s.stop():_s.start()},ce.addEventListener("sessionstart",Vl),ce.addEventListener("sessionend",ts),this.render=function(E,G){if(G!==void 0&&G.isCamera!==!0){tt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(N===!0)return;k!==null&&k.renderStart(E,G);let J=ce.enabled===!0&&ce.isPresenting===!0,Y=U!==null&&(ae===null||J)&&U.begin(L,ae);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(G),G=ce.getCamera()),E.isScene===!0&&E.onBeforeRender(L,E,G,ae),A=ee.get(E,w.length),A.init(G),A.state.textureUnits=Ye.getTextureUnits(),w.push(A),Ut.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),G.isArrayCamera?Kt.setFromArrayCamera(G):rt.setFromProjectionMatrix(Ut,Ti,G.reversedDepth),_n=this.localClippingEnabled,Vt=ie.init(this.clippingPlanes,_n),C=ve.get(E,_.length),C.init(),_.push(C),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Le=L.xr.getDepthSensingMesh();Le!==null&&xs(Le,G,-1/0,L.sortObjects)}xs(E,G,0,L.sortObjects),C.finish(),k!==null&&k.updateLights(A.state.lightsArray),L.sortObjects===!0&&C.sort(Xe,at),rn=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,rn&&O.addToRenderList(C,E),this.info.autoReset===!0&&this.info.reset(),Vt===!0&&ie.beginShadows();let Z=A.state.shadowsArray;if(pe.render(Z,E,G),Vt===!0&&ie.endShadows(),(Y&&U.hasRenderPass())===!1){let Le=C.opaque,Ce=C.transmissive;if(A.setupLights(),G.isArrayCamera){let Ne=G.cameras;if(Ce.length>0)for(let Ge=0,nt=Ne.length;Ge<nt;Ge++){let pt=Ne[Ge];Ui(Le,Ce,E,pt)}rn&&O.render(E);for(let Ge=0,nt=Ne.length;Ge<nt;Ge++){let pt=Ne[Ge];la(C,E,pt,pt.viewport)}}else Ce.length>0&&Ui(Le,Ce,E,G),rn&&O.render(E),la(C,E,G)}ae!==null&&V===0&&(Ye.updateMultisampleRenderTarget(ae),Ye.updateRenderTargetMipmap(ae)),Y&&U.end(L),E.isScene===!0&&E.onAfterRender(L,E,G),be.resetDefaultState(),q=-1,K=null,w.pop(),w.length>0?(A=w[w.length-1],Ye.setTextureUnits(A.state.textureUnits),Vt===!0&&ie.setGlobalState(L.clippingPlanes,A.state.camera)):A=null,_.pop(),_.length>0?C=_[_.length-1]:C=null,k!==null&&k.renderEnd()};function xs(E,G,J,Y){if(E.visible===!1)return;if(E.layers.test(G.layers)){if(E.isGroup)J=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(G);else if(E.isLight)A.pushLight(E),E.castShadow&&A.pushShadow(E);else if(E.isSprite){let Le=G.isArrayCamera?Kt:rt;if(!E.frustumCulled||E.intersectsFrustum(Le)){Y&&Mt.setFromMatrixPosition(E.matrixWorld).applyMatrix4(Ut);let Ce=ue.update(E),Ne=E.material;Ne.visible&&C.push(E,Ce,Ne,J,Mt.z,null,G)}}else if(E.isMesh||E.isLine||E.isPoints){let Le=G.isArrayCamera?Kt:rt;if(!E.frustumCulled||E.intersectsFrustum(Le)){let Ce=ue.update(E),Ne=E.material;if(Y&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),Mt.copy(E.boundingSphere.center)):(Ce.boundingSphere===null&&Ce.computeBoundingSphere(),Mt.copy(Ce.boundingSphere.center)),Mt.applyMatrix4(E.matrixWorld).applyMatrix4(Ut)),Array.isArray(Ne)){let Ge=Ce.groups;for(let nt=0,pt=Ge.length;nt<pt;nt++){let ze=Ge[nt],mt=Ne[ze.materialIndex];mt&&mt.visible&&C.push(E,Ce,mt,J,Mt.z,ze,G)}}else Ne.visible&&C.push(E,Ce,Ne,J,Mt.z,null,G)}}}let Te=E.children;for(let Le=0,Ce=Te.length;Le<Ce;Le++)xs(Te[Le],G,J,Y)}function la(E,G,J,Y){let{opaque:Z,transmissive:Te,transparent:Le}=E;A.setupLightsView(J),Vt===!0&&ie.setGlobalState(L.clippingPlanes,J),Y&&Ee.viewport(ne.copy(Y)),Z.length>0&&on(Z,G,J),Te.length>0&&on(Te,G,J),Le.length>0&&on(Le,G,J),Ee.buffers.depth.setTest(!0),Ee.buffers.depth.setMask(!0),Ee.buffers.color.setMask(!0),Ee.setPolygonOffset(!1)}function Ui(E,G,J,Y){if((J.isScene===!0?J.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[Y.id]===void 0){let ze=je.has("EXT_color_buffer_half_float")||je.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[Y.id]=new gi(1,1,{generateMipmaps:!0,type:ze?Yi:$n,minFilter:Us,samples:Math.max(4,lt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:xt.workingColorSpace})}let Te=A.state.transmissionRenderTarget[Y.id],Le=Y.viewport||ne;Te.setSize(Le.z*L.transmissionResolutionScale,Le.w*L.transmissionResolutionScale);let Ce=L.getRenderTarget(),Ne=L.getActiveCubeFace(),Ge=L.getActiveMipmapLevel();L.setRenderTarget(Te),L.getClearColor(Q),me=L.getClearAlpha(),me<1&&L.setClearColor(16777215,.5),L.clear(),rn&&O.render(J);let nt=L.toneMapping;L.toneMapping=hs;let pt=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),A.setupLightsView(Y),Vt===!0&&ie.setGlobalState(L.clippingPlanes,Y),on(E,J,Y),Ye.updateMultisampleRenderTarget(Te),Ye.updateRenderTargetMipmap(Te),je.has("WEBGL_multisampled_render_to_texture")===!1){let ze=!1;for(let mt=0,sn=G.length;mt<sn;mt++){let It=G[mt],{object:Lt,geometry:An,material:Oe,group:vn}=It;if(Oe.side===Ri&&Lt.layers.test(Y.layers)){let _t=Oe.side;Oe.side=ri,Oe.needsUpdate=!0,pn(Lt,J,Y,An,Oe,vn),Oe.side=_t,Oe.needsUpdate=!0,ze=!0}}ze===!0&&(Ye.updateMultisampleRenderTarget(Te),Ye.updateRenderTargetMipmap(Te))}L.setRenderTarget(Ce,Ne,Ge),L.setClearColor(Q,me),pt!==void 0&&(Y.viewport=pt),L.toneMapping=nt}function on(E,G,J){let Y=G.isScene===!0?G.overrideMaterial:null;for(let Z=0,Te=E.length;Z<Te;Z++){let Le=E[Z],{object:Ce,geometry:Ne,group:Ge}=Le,nt=Le.material;nt.allowOverride===!0&&Y!==null&&(nt=Y),Ce.layers.test(J.layers)&&pn(Ce,G,J,Ne,nt,Ge)}}function pn(E,G,J,Y,Z,Te){k!==null&&Z.isNodeMaterial&&k.setObject(E,Z),E.onBeforeRender(L,G,J,Y,Z,Te),E.modelViewMatrix.multiplyMatrices(J.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),Z.onBeforeRender(L,G,J,Y,E,Te),Z.transparent===!0&&Z.side===Ri&&Z.forceSinglePass===!1?(Z.side=ri,Z.needsUpdate=!0,L.renderBufferDirect(J,G,Y,Z,E,Te),Z.side=lr,Z.needsUpdate=!0,L.renderBufferDirect(J,G,Y,Z,E,Te),Z.side=Ri):L.renderBufferDirect(J,G,Y,Z,E,Te),E.onAfterRender(L,G,J,Y,Z,Te)}function mn(E){let G=0;for(let J of E)J.texture!==null&&G++;return G}function ns(E,G,J){G.isScene!==!0&&(G=En);let Y=Ve.get(E),Z=A.state.lights,Te=A.state.shadowsArray,Le=Z.state.version,Ce=re.getParameters(E,Z.state,Te,G,J,A.state.lightProbeGridArray),Ne=re.getProgramCacheKey(Ce),Ge=Y.programs;Y.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?G.environment:null,Y.fog=G.fog;let nt=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;Y.envMap=R.get(E.envMap||Y.environment,nt),Y.envMapRotation=Y.environment!==null&&E.envMap===null?G.environmentRotation:E.envMapRotation,Ge===void 0&&(E.addEventListener("dispose",ct),Ge=new Map,Y.programs=Ge,Y.programVariants=new Map);let pt=Ge.get(Ne);if(pt!==void 0){if(Y.currentProgram===pt&&Y.lightsStateVersion===Le)return ca(E,Ce),pt}else Ce.uniforms=re.getUniforms(E),k!==null&&E.isNodeMaterial&&k.build(E,J,Ce),E.onBeforeCompile(Ce,L),pt=re.acquireProgram(Ce,Ne),Ge.set(Ne,pt),Y.uniforms=Ce.uniforms;let ze=Y.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(ze.clippingPlanes=ie.uniform),ca(E,Ce),Y.needsLights=Ws(E),Y.lightsStateVersion=Le,Y.needsLights&&(ze.ambientLightColor.value=Z.state.ambient,ze.lightProbe.value=Z.state.probe,ze.sunLights.value=Z.state.sun,ze.sunLightShadows.value=Z.state.sunShadow,ze.directionalLights.value=Z.state.directional,ze.directionalLightShadows.value=Z.state.directionalShadow,ze.spotLights.value=Z.state.spot,ze.spotLightShadows.value=Z.state.spotShadow,ze.rectAreaLights.value=Z.state.rectArea,ze.ltc_1.value=Z.state.rectAreaLTC1,ze.ltc_2.value=Z.state.rectAreaLTC2,ze.pointLights.value=Z.state.point,ze.pointLightShadows.value=Z.state.pointShadow,ze.hemisphereLights.value=Z.state.hemi,ze.sunShadowMatrix.value=Z.state.sunShadowMatrix,ze.sunShadowCascade.value=Z.state.sunShadowCascade,ze.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,ze.spotLightMatrix.value=Z.state.spotLightMatrix,ze.spotLightMap.value=Z.state.spotLightMap,ze.pointShadowMatrix.value=Z.state.pointShadowMatrix),Y.numLightProbeGrids=mn(A.state.lightProbeGridArray),Y.currentProgram=pt,Y.uniformsList=null,pt}function ui(E,G,J,Y,Z){let Te=Ve.get(E),Le=Te.currentProgram.id+","+Y+","+Z,Ce=Te.programVariants.get(Le);return Ce===void 0?(Ce=ns(E,G,J),Te.programVariants.set(Le,Ce)):(Te.currentProgram=Ce,Te.uniformsList=null,Te.outputColorSpace=Y,Te.toneMapping=Z),Ce}function Hs(E){if(E.uniformsList===null){let G=E.currentProgram.getUniforms();E.uniformsList=No.seqWithValue(G.seq,E.uniforms)}return E.uniformsList}function ca(E,G){let J=Ve.get(E);J.outputColorSpace=G.outputColorSpace,J.batching=G.batching,J.batchingColor=G.batchingColor,J.instancing=G.instancing,J.instancingColor=G.instancingColor,J.instancingMorph=G.instancingMorph,J.skinning=G.skinning,J.morphTargets=G.morphTargets,J.morphNormals=G.morphNormals,J.morphColors=G.morphColors,J.morphTargetsCount=G.morphTargetsCount,J.numClippingPlanes=G.numClippingPlanes,J.numIntersection=G.numClipIntersection,J.vertexAlphas=G.vertexAlphas,J.vertexTangents=G.vertexTangents,J.toneMapping=G.toneMapping}function ua(E,G,J,Y,Z){G.isScene!==!0&&(G=En),Ye.resetTextureUnits();let Te=G.fog,Le=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?G.environment:null,Ce=ae===null?L.outputColorSpace:ae.isXRRenderTarget===!0?ae.texture.colorSpace:xt.workingColorSpace,Ne=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Ge=R.get(Y.envMap||Le,Ne),nt=Y.vertexColors===!0&&!!J.attributes.color&&J.attributes.color.itemSize===4,pt=!!J.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),ze=!!J.morphAttributes.position,mt=!!J.morphAttributes.normal,sn=!!J.morphAttributes.color,It=hs;Y.toneMapped&&(ae===null||ae.isXRRenderTarget===!0)&&(It=L.toneMapping);let Lt=J.morphAttributes.position||J.morphAttributes.normal||J.morphAttributes.color,An=Lt!==void 0?Lt.length:0,Oe=Ve.get(Y),vn=A.state.lights;if(Vt===!0&&(_n===!0||E!==K)){let Nt=E===K&&Y.id===q;ie.setState(Y,E,Nt)}let _t=!1,vs=!1;Y.version===Oe.__version?Oe.needsLights&&Oe.lightsStateVersion!==vn.state.version||Z.isBatchedMesh&&Oe.batching===!1||!Z.isBatchedMesh&&Oe.batching===!0||Z.isBatchedMesh&&Oe.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Oe.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Oe.instancing===!1||!Z.isInstancedMesh&&Oe.instancing===!0||Z.isSkinnedMesh&&Oe.skinning===!1||!Z.isSkinnedMesh&&Oe.skinning===!0||Z.isInstancedMesh&&Oe.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Oe.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Oe.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Oe.instancingMorph===!1&&Z.morphTexture!==null||Oe.envMap!==Ge||Y.fog===!0&&Oe.fog!==Te||Oe.numClippingPlanes!==void 0&&(Oe.numClippingPlanes!==ie.numPlanes||Oe.numIntersection!==ie.numIntersection)||Oe.vertexAlphas!==nt||Oe.vertexTangents!==pt||Oe.morphTargets!==ze||Oe.morphNormals!==mt||Oe.morphColors!==sn||Oe.morphTargetsCount!==An||Oe.numLightProbeGrids!==mn(A.state.lightProbeGridArray)?_t=!0:(Oe.outputColorSpace!==Ce||Oe.toneMapping!==It)&&(vs=!0):(_t=!0,Oe.__version=Y.version);let yn=Oe.currentProgram;(_t===!0||vs===!0)&&(yn=vs===!0?ui(Y,G,Z,Ce,It):ns(Y,G,Z),k&&Y.isNodeMaterial&&k.onUpdateProgram(Y,yn,Oe));let Zr=!1,is=!1,ys=!1,ht=yn.getUniforms(),an=Oe.uniforms;if(Ee.useProgram(yn.program)&&(Zr=!0,is=!0,ys=!0),Y.id!==q&&(q=Y.id,is=!0),Zr||K!==E){Ee.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),ht.setValue(B,"projectionMatrix",E.projectionMatrix),ht.setValue(B,"viewMatrix",E.matrixWorldInverse);let Sn=ht.map.cameraPosition;Sn!==void 0&&Sn.setValue(B,Nn.setFromMatrixPosition(E.matrixWorld)),lt.logarithmicDepthBuffer&&ht.setValue(B,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&ht.setValue(B,"isOrthographic",E.isOrthographicCamera===!0),K!==E&&(K=E,is=!0,ys=!0)}if(Oe.needsLights&&(vn.state.sunShadowMap.length>0&&ht.setValue(B,"sunShadowMap",vn.state.sunShadowMap,Ye),vn.state.directionalShadowMap.length>0&&ht.setValue(B,"directionalShadowMap",vn.state.directionalShadowMap,Ye),vn.state.spotShadowMap.length>0&&ht.setValue(B,"spotShadowMap",vn.state.spotShadowMap,Ye),vn.state.pointShadowMap.length>0&&ht.setValue(B,"pointShadowMap",vn.state.pointShadowMap,Ye)),Z.isSkinnedMesh){ht.setOptional(B,Z,"bindMatrix"),ht.setOptional(B,Z,"bindMatrixInverse");let Nt=Z.skeleton;Nt&&(Nt.boneTexture===null&&Nt.computeBoneTexture(),ht.setValue(B,"boneTexture",Nt.boneTexture,Ye))}Z.isBatchedMesh&&(ht.setOptional(B,Z,"batchingTexture"),ht.setValue(B,"batchingTexture",Z._matricesTexture,Ye),ht.setOptional(B,Z,"batchingIdTexture"),ht.setValue(B,"batchingIdTexture",Z._indirectTexture,Ye),ht.setOptional(B,Z,"batchingColorTexture"),Z._colorsTexture!==null&&ht.setValue(B,"batchingColorTexture",Z._colorsTexture,Ye));let Kn=J.morphAttributes;if((Kn.position!==void 0||Kn.normal!==void 0||Kn.color!==void 0)&&se.update(Z,J,yn),(is||Oe.receiveShadow!==Z.receiveShadow)&&(Oe.receiveShadow=Z.receiveShadow,ht.setValue(B,"receiveShadow",Z.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&G.environment!==null&&(an.envMapIntensity.value=G.environmentIntensity),an.dfgLUT!==void 0&&(an.dfgLUT.value=zA()),is){if(ht.setValue(B,"toneMappingExposure",L.toneMappingExposure),Oe.needsLights&&$r(an,ys),Te&&Y.fog===!0&&_e.refreshFogUniforms(an,Te),_e.refreshMaterialUniforms(an,Y,we,Re,A.state.transmissionRenderTarget[E.id]),Oe.needsLights&&Oe.numLightProbeGrids>0){let Nt=S,Sn=0;for(let Wn of A.state.lightProbeGridArray)Wn.texture!==null&&(Nt.textures[Sn]=Wn.texture,Nt.min[Sn]=Wn.boundingBox.min,Nt.max[Sn]=Wn.boundingBox.max,Nt.resolution[Sn]=Wn.resolution,Sn++);for(let Wn in Nt)Nt[Wn].length=Sn;an.probesSH.value=Nt.textures,an.probesMin.value=Nt.min,an.probesMax.value=Nt.max,an.probesResolution.value=Nt.resolution}No.upload(B,Hs(Oe),an,Ye)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(No.upload(B,Hs(Oe),an,Ye),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&ht.setValue(B,"center",Z.center),ht.setValue(B,"modelViewMatrix",Z.modelViewMatrix),ht.setValue(B,"normalMatrix",Z.normalMatrix),ht.setValue(B,"modelMatrix",Z.matrixWorld),Y.uniformsGroups!==void 0){let Nt=Y.uniformsGroups;for(let Sn=0,Wn=Nt.length;Sn<Wn;Sn++){let Hl=Nt[Sn];We.update(Hl,yn),We.bind(Hl,yn)}}return yn}function $r(E,G){E.ambientLightColor.needsUpdate=G,E.lightProbe.needsUpdate=G,E.sunLights.needsUpdate=G,E.sunLightShadows.needsUpdate=G,E.directionalLights.needsUpdate=G,E.directionalLightShadows.needsUpdate=G,E.pointLights.needsUpdate=G,E.pointLightShadows.needsUpdate=G,E.spotLights.needsUpdate=G,E.spotLightShadows.needsUpdate=G,E.rectAreaLights.needsUpdate=G,E.hemisphereLights.needsUpdate=G}function Ws(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return ae},this.setRenderTargetTextures=function(E,G,J){let Y=Ve.get(E);Y.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),Ve.get(E.texture).__webglTexture=G,Ve.get(E.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:J,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,G){let J=Ve.get(E);J.__webglFramebuffer=G,J.__useDefaultFramebuffer=G===void 0},this.setRenderTarget=function(E,G=0,J=0){ae=E,$=G,V=J;let Y=null,Z=!1,Te=!1;if(E){let Ce=Ve.get(E);if(Ce.__useDefaultFramebuffer!==void 0){Ee.bindFramebuffer(B.FRAMEBUFFER,Ce.__webglFramebuffer),ne.copy(E.viewport),he.copy(E.scissor),fe=E.scissorTest,Ee.viewport(ne),Ee.scissor(he),Ee.setScissorTest(fe),q=-1;return}else if(Ce.__webglFramebuffer===void 0)Ye.setupRenderTarget(E);else if(Ce.__hasExternalTextures)Ye.rebindTextures(E,Ve.get(E.texture).__webglTexture,Ve.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let nt=E.depthTexture;if(Ce.__boundDepthTexture!==nt){if(nt!==null&&Ve.has(nt)&&(E.width!==nt.image.width||E.height!==nt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ye.setupDepthRenderbuffer(E)}}let Ne=E.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Te=!0);let Ge=Ve.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Ge[G])?Y=Ge[G][J]:Y=Ge[G],Z=!0):E.samples>0&&Ye.useMultisampledRTT(E)===!1?Y=Ve.get(E).__webglMultisampledFramebuffer:Array.isArray(Ge)?Y=Ge[J]:Y=Ge,ne.copy(E.viewport),he.copy(E.scissor),fe=E.scissorTest}else ne.copy(He).multiplyScalar(we).floor(),he.copy(dt).multiplyScalar(we).floor(),fe=ut;if(J!==0&&(Y=H),Ee.bindFramebuffer(B.FRAMEBUFFER,Y)&&Ee.drawBuffers(E,Y),Ee.viewport(ne),Ee.scissor(he),Ee.setScissorTest(fe),Z){let Ce=Ve.get(E.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+G,Ce.__webglTexture,J)}else if(Te){let Ce=G;for(let Ne=0;Ne<E.textures.length;Ne++){let Ge=Ve.get(E.textures[Ne]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Ne,Ge.__webglTexture,J,Ce)}}else if(E!==null&&J!==0){let Ce=Ve.get(E.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Ce.__webglTexture,J)}q=-1};function Yr(E){let G=Ve.get(E);return(G.__readFormat!==E.format||G.__readType!==E.type)&&(G.__readFormat=E.format,G.__readType=E.type,G.__formatReadable=lt.textureFormatReadable(E.format),G.__typeReadable=lt.textureTypeReadable(E.type)),G}this.readRenderTargetPixels=function(E,G,J,Y,Z,Te,Le,Ce=0){if(!(E&&E.isWebGLRenderTarget)){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=Ve.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Le!==void 0&&(Ne=Ne[Le],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){Ee.bindFramebuffer(B.FRAMEBUFFER,Ne);try{let Ge=E.textures[Ce],nt=Ge.format,pt=Ge.type;E.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ce);let ze=Yr(Ge);if(ze.__formatReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ze.__typeReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=E.width-Y&&J>=0&&J<=E.height-Z&&B.readPixels(G,J,Y,Z,ge.convert(nt),ge.convert(pt),Te)}finally{let Ge=ae!==null?Ve.get(ae).__webglFramebuffer:null;Ee.bindFramebuffer(B.FRAMEBUFFER,Ge)}}},this.readRenderTargetPixelsAsync=async function(E,G,J,Y,Z,Te,Le,Ce=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=Ve.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Le!==void 0&&(Ne=Ne[Le],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(G>=0&&G<=E.width-Y&&J>=0&&J<=E.height-Z){Ee.bindFramebuffer(B.FRAMEBUFFER,Ne);let Ge=E.textures[Ce],nt=Ge.format,pt=Ge.type;E.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ce);let ze=Yr(Ge);if(ze.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ze.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let mt=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,mt),B.bufferData(B.PIXEL_PACK_BUFFER,Te.byteLength,B.STREAM_READ),B.readPixels(G,J,Y,Z,ge.convert(nt),ge.convert(pt),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let sn=ae!==null?Ve.get(ae).__webglFramebuffer:null;Ee.bindFramebuffer(B.FRAMEBUFFER,sn);let It=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await Ig(B,It,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,mt),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Te),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(mt),B.deleteSync(It),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,G=null,J=0){let Y=Math.pow(2,-J),Z=Math.floor(E.image.width*Y),Te=Math.floor(E.image.height*Y),Le=G!==null?G.x:0,Ce=G!==null?G.y:0;Ye.setTexture2D(E,0),B.copyTexSubImage2D(B.TEXTURE_2D,J,0,0,Le,Ce,Z,Te),Ee.unbindTexture()},this.copyTextureToTexture=function(E,G,J=null,Y=null,Z=0,Te=0){let Le,Ce,Ne,Ge,nt,pt,ze,mt,sn,It=E.isCompressedTexture?E.mipmaps[Te]:E.image;if(J!==null)Le=J.max.x-J.min.x,Ce=J.max.y-J.min.y,Ne=J.isBox3?J.max.z-J.min.z:1,Ge=J.min.x,nt=J.min.y,pt=J.isBox3?J.min.z:0;else{let ht=Math.pow(2,-Z);Le=Math.floor(It.width*ht),Ce=Math.floor(It.height*ht),E.isDataArrayTexture?Ne=It.depth:E.isData3DTexture?Ne=Math.floor(It.depth*ht):Ne=1,Ge=0,nt=0,pt=0}Y!==null?(ze=Y.x,mt=Y.y,sn=Y.z):(ze=0,mt=0,sn=0);let Lt=ge.convert(G.format),An=ge.convert(G.type),Oe;G.isData3DTexture?(Ye.setTexture3D(G,0),Oe=B.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?(Ye.setTexture2DArray(G,0),Oe=B.TEXTURE_2D_ARRAY):(Ye.setTexture2D(G,0),Oe=B.TEXTURE_2D),Ee.activeTexture(B.TEXTURE0),Ee.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,G.flipY),Ee.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),Ee.pixelStorei(B.UNPACK_ALIGNMENT,G.unpackAlignment);let vn=Ee.getParameter(B.UNPACK_ROW_LENGTH),_t=Ee.getParameter(B.UNPACK_IMAGE_HEIGHT),vs=Ee.getParameter(B.UNPACK_SKIP_PIXELS),yn=Ee.getParameter(B.UNPACK_SKIP_ROWS),Zr=Ee.getParameter(B.UNPACK_SKIP_IMAGES);Ee.pixelStorei(B.UNPACK_ROW_LENGTH,It.width),Ee.pixelStorei(B.UNPACK_IMAGE_HEIGHT,It.height),Ee.pixelStorei(B.UNPACK_SKIP_PIXELS,Ge),Ee.pixelStorei(B.UNPACK_SKIP_ROWS,nt),Ee.pixelStorei(B.UNPACK_SKIP_IMAGES,pt);let is=E.isDataArrayTexture||E.isData3DTexture,ys=G.isDataArrayTexture||G.isData3DTexture;if(E.isDepthTexture){let ht=Ve.get(E),an=Ve.get(G),Kn=Ve.get(ht.__renderTarget),Nt=Ve.get(an.__renderTarget);Ee.bindFramebuffer(B.READ_FRAMEBUFFER,Kn.__webglFramebuffer),Ee.bindFramebuffer(B.DRAW_FRAMEBUFFER,Nt.__webglFramebuffer);for(let Sn=0;Sn<Ne;Sn++)is&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ve.get(E).__webglTexture,Z,pt+Sn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ve.get(G).__webglTexture,Te,sn+Sn)),B.blitFramebuffer(Ge,nt,Ge+Le,nt+Ce,ze,mt,ze+Le,mt+Ce,B.DEPTH_BUFFER_BIT,B.NEAREST);Ee.bindFramebuffer(B.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(Z!==0||E.isRenderTargetTexture||Ve.has(E)){let ht=Ve.get(E),an=Ve.get(G);Ee.bindFramebuffer(B.READ_FRAMEBUFFER,I),Ee.bindFramebuffer(B.DRAW_FRAMEBUFFER,z);for(let Kn=0;Kn<Ne;Kn++)is?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ht.__webglTexture,Z,pt+Kn):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ht.__webglTexture,Z),ys?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,an.__webglTexture,Te,sn+Kn):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,an.__webglTexture,Te),Z!==0?B.blitFramebuffer(Ge,nt,Ge+Le,nt+Ce,ze,mt,ze+Le,mt+Ce,B.COLOR_BUFFER_BIT,B.NEAREST):ys?B.copyTexSubImage3D(Oe,Te,ze,mt,sn+Kn,Ge,nt,Le,Ce):B.copyTexSubImage2D(Oe,Te,ze,mt,Ge,nt,Le,Ce);Ee.bindFramebuffer(B.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else ys?E.isDataTexture||E.isData3DTexture?B.texSubImage3D(Oe,Te,ze,mt,sn,Le,Ce,Ne,Lt,An,It.data):G.isCompressedArrayTexture?B.compressedTexSubImage3D(Oe,Te,ze,mt,sn,Le,Ce,Ne,Lt,It.data):B.texSubImage3D(Oe,Te,ze,mt,sn,Le,Ce,Ne,Lt,An,It):E.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Te,ze,mt,Le,Ce,Lt,An,It.data):E.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Te,ze,mt,It.width,It.height,Lt,It.data):B.texSubImage2D(B.TEXTURE_2D,Te,ze,mt,Le,Ce,Lt,An,It);Ee.pixelStorei(B.UNPACK_ROW_LENGTH,vn),Ee.pixelStorei(B.UNPACK_IMAGE_HEIGHT,_t),Ee.pixelStorei(B.UNPACK_SKIP_PIXELS,vs),Ee.pixelStorei(B.UNPACK_SKIP_ROWS,yn),Ee.pixelStorei(B.UNPACK_SKIP_IMAGES,Zr),Te===0&&G.generateMipmaps===!0&&G.mipmapsAutoUpdate===!0&&B.generateMipmap(Oe),Ee.unbindTexture()},this.initRenderTarget=function(E){Ve.get(E).__webglFramebuffer===void 0&&Ye.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?Ye.setTextureCube(E,0):E.isData3DTexture?Ye.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?Ye.setTexture2DArray(E,0):Ye.setTexture2D(E,0),Ee.unbindTexture()},this.resetState=function(){$=0,V=0,ae=null,Ee.reset(),be.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ti}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let n=this.getContext();n.drawingBufferColorSpace=xt._getDrawingBufferColorSpace(e),n.unpackColorSpace=xt._getUnpackColorSpace()}};function g0(){let t={camera:new ii(30,1,.01,100),target:new F,home:null,azimuth:.75,elevation:.4,distance:4.2,changed:!0,pushed:null};return t.home={azimuth:t.azimuth,elevation:t.elevation,distance:t.distance},ji(t),t}function ji(t){let e=t.distance*Math.cos(t.elevation);t.camera.up.set(0,0,1),t.camera.position.set(t.target.x+e*Math.cos(t.azimuth),t.target.y+e*Math.sin(t.azimuth),t.target.z+t.distance*Math.sin(t.elevation)),t.camera.lookAt(t.target),t.camera.updateMatrixWorld(),t.changed=!0}function dd(t,e,n){t.azimuth-=.006*e,t.elevation=Math.max(-1.5,Math.min(1.5,t.elevation+.006*n)),ji(t)}function _0(t,[e,n,i]){t.azimuth=e===0&&n===0?-Math.PI/2:Math.atan2(n,e),t.elevation=Math.max(-1.5,Math.min(1.5,Math.atan2(i,Math.hypot(e,n)))),ji(t)}function Uo(t,e){t.distance=Math.max(.3,Math.min(30,t.distance*e)),ji(t)}function pd(t,e,n,i){let{right:s,up:r}=cr(t),o=rl(t,t.distance,i);t.target.addScaledVector(s,-e*o).addScaledVector(r,n*o),ji(t)}var GA=5;function md(t,e){let n=t.pushed;if(t.pushed=e,!n||!e)return;let[i,s,r]=e.position.map((u,h)=>GA*(u-n.position[h])),o=new Tt(...n.quat_xyzw),a=new Tt(...e.quat_xyzw).multiply(o.invert()),l=a.w<0?-2:2,c=cr(t);t.target.addScaledVector(c.right,-s*t.distance).addScaledVector(c.up,-r*t.distance),t.distance=Math.max(.3,Math.min(30,t.distance*Math.exp(-i))),t.azimuth-=l*a.z,t.elevation=Math.max(-1.5,Math.min(1.5,t.elevation+l*a.y)),ji(t)}function Gu(t){Object.assign(t,t.home),t.target.set(0,0,0),ji(t)}function cr(t){let e=new F,n=new F,i=new F;return t.camera.matrixWorld.extractBasis(e,n,i),{right:e,up:n,forward:i.negate()}}function rl(t,e,n){return 2*Math.tan(t.camera.fov*Math.PI/360)*e/Math.max(1,n)}function ol(t,e){let{forward:n}=cr(t);return Math.max(.05,e.clone().sub(t.camera.position).dot(n))}var VA={pause:"M8 5v14M16 5v14",play:"M8 5l11 7-11 7z",step:"M6 5l8 7-8 7zM18 5v14",reset:"M5 12a7 7 0 1 0 2.3-5.2M5 4v4.5h4.5",record:"M12 12m-5.5 0a5.5 5.5 0 1 0 11 0a5.5 5.5 0 1 0-11 0",stop:"M7 7h10v10H7z",theme:"M12 4a8 8 0 1 0 0 16zM12 4a8 8 0 0 1 0 16",help:"M9 9a3 3 0 1 1 4.2 2.75c-.8.4-1.2 1-1.2 2.25M12 17.5v.5",fit:"M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5",levels:"M12 4l8 14H4zM8 11h8M12 4v14",ghost:"M6 20V10a6 6 0 0 1 12 0v10l-3-2-3 2-3-2zM10 10v.5M14 10v.5",contacts:"M4 16h16M8 16v-6M16 16v-6M6 12l2-2.5 2 2.5M14 12l2-2.5 2 2.5",forces:"M5 19L19 5M19 5h-7M19 5v7",sound:"M4 10v4h3l5 4V6l-5 4zM15.5 9a4 4 0 0 1 0 6M18 6.5a8 8 0 0 1 0 11",names:"M4 5h9l7 7-7 7H4zM8 12h.5",open:"M3 18V6h6l2 2.5h10V18z",headset:"M3 8.5A1.5 1.5 0 0 1 4.5 7h15A1.5 1.5 0 0 1 21 8.5v7a1.5 1.5 0 0 1-1.5 1.5H16l-2.5-2.5h-3L8 17H4.5A1.5 1.5 0 0 1 3 15.5zM7.5 11.5h2M14.5 11.5h2",room:"M3 8.5A1.5 1.5 0 0 1 4.5 7h15A1.5 1.5 0 0 1 21 8.5v7a1.5 1.5 0 0 1-1.5 1.5H16l-2.5-2.5h-3L8 17H4.5A1.5 1.5 0 0 1 3 15.5zM12 3v2M12 19v2",add:"M12 5v14M5 12h14",remove:"M5 12h14",save:"M12 4v11M7 11l5 5 5-5M5 20h14",hand:"M8 12V6a1.5 1.5 0 0 1 3 0v5V4.5a1.5 1.5 0 0 1 3 0V11V6a1.5 1.5 0 0 1 3 0v8c0 4-2 6-5.5 6S7 18 6 15l-1-2.5c-.5-1.5 1.5-2.3 2.2-1z"};function Vu(t){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let n=document.createElementNS("http://www.w3.org/2000/svg","path");return n.setAttribute("d",VA[t]),e.append(n),e}function Zn(t,e,n,i){let s=Object.assign(document.createElement("button"),{type:"button",className:`icon ${t}`});return s.append(Vu(t)),Fo(s,e,n),s.addEventListener("click",()=>i(s)),s}function Fo(t,e,n){t.title=n?`${e} (${n})`:e,t.setAttribute("aria-label",e)}function al(t,e){t.dataset.icon!==e&&(t.dataset.icon=e,t.replaceChildren(Vu(e)))}var gd=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"],[1e-9,"n"],[1e-12,"p"]];function _d(t,e,n=1e-6){if(t==null||!Number.isFinite(t))return{number:"–",unit:e};let i=Math.abs(t);if(i<.005*n)return{number:"0",unit:e};let[s,r]=gd[gd.length-1];for(let[o,a]of gd)if(i>=.9995*o||o<=n){[s,r]=[o,a];break}return{number:Pi(t/s),unit:r+e}}function Pi(t){let e=Math.abs(t);return t.toFixed(e<9.995?2:e<99.95?1:0)}function jn(t,e,n){let{number:i,unit:s}=_d(t,e,n);return i==="–"?i:`${i} ${s}`}function Pr(t){if(!Number.isFinite(t))return"–";if(t<60)return`${t.toFixed(1)} s`;let e=Math.floor(t);return`${Math.floor(e/60)}:${String(e%60).padStart(2,"0")} min`}function oi(t,e,n=`${e}s`){return`${t} ${t===1?e:n}`}var HA={device_lost:"the hand was lost",watchdog:"the haptic loop stood still",not_finite:"a number was not finite",too_fast:"the hand moved too fast",pose_jump:"the hand jumped",turned_too_fast:"the hand turned too fast",orientation_jump:"the hand's direction jumped",contact_stale:"the contact model was too old"},WA={grasped:"The hand took hold of the object",released:"The hand let the object go",armed:"Forces are on",disarmed:"Forces are off",late:"Late",recording_ended:"The recording has ended",not_armed:"Forces stay off",resumed:"Goes on",parameter:"Parameter changed",fault:"Fault",held_back:"Held back",squeezed:"Squeezed"},xd={fault:"ended by a fault",duration:"reached its duration",device_finished:"the hand has finished",stopped:"was stopped"},XA={hand:"simulated hand",web:"mouse or touch",script:"scripted hand",replay:"recorded hand",null:"no hand","":"a recording"};function x0(t){return XA[String(t).split(":")[0]]??t}function Ir(t){return HA[t]??String(t).replaceAll("_"," ")}function Hu({reason:t,fault:e}){let n=xd[t];return!n||t!=="fault"||!e?n:`${n}: ${Ir(e.name)}${e.text?` (${e.text})`:""}`}function v0(t,e){return!t||!(e-t.time<6)?null:`The computer was late (${t.count===1?"once":`${t.count} times so far`}): ${t.text??Ir(t.name)}.`}function Wu({kind:t,detail:e,text:n}){let i=WA[t]??String(t).replaceAll("_"," "),r=[t==="fault"||t==="late"?Ir(e):t==="held_back"?"":e,n].filter(Boolean).join("; ");return r?`${i}: ${r}`:i}function y0(t){let{object:e,statics:n,grasped:i,contacts:s,clusters:r}=t,o=`The ${e}`;if(s===0)return`${o} ${i?"is in the hand and":"rests and"} touches nothing.`;let a=n.length===1?`the ${n[0]}`:"the scene",l=s===1?"1 contact":`${s} contacts`,c=r===0?"":r===1?" in 1 cluster":` in ${r} clusters`;return t.touching&&t.armed===!1?`${o} touches ${a} at ${l}${c}; forces are off.`:t.touching?`${o} presses on ${a} at ${l}${c}.`:`${o} is close to ${a}: ${l}${c}.`}function S0(t){let{object:e,statics:n,rows:i,pressing:s}=t,r=n.length===1?`the ${n[0]}`:"the scene";if(i===0)return`The ${e} ${t.grasped?"is in the hand and":"rests and"} touches nothing.`;if(s===0)return`The ${e} is close to ${r}: ${i===1?"1 row":`${i} rows`} near, none presses.`;let o=`The ${e} rests on ${s===1?"1 row":`${s} rows`} of ${r}`;return t.armed===!1?`${o}; forces are off.`:`${o}; the hand pulls ${t.newtons}${t.stiffness?`; coupling ${t.stiffness}`:""}.`}function M0(t,e){if(!e)return"Nothing is known of the bodies yet.";let n=[t.object,...t.statics],i=u=>n.find(({body:h})=>h===u)?.name,s=n.filter(({moves:u})=>u),r=s.filter(({body:u})=>e.bodies[u]&&!e.bodies[u].asleep).length,o=e.hands.filter(({body:u})=>u>=0).map(({body:u,page:h})=>`${h?"the mouse":"a hand"} holds ${i(u)}`),a=s.length===1?"1 body moves freely":`${s.length} bodies move freely`,l=r===0?"all of them rest":r===s.length?"all are awake":`${s.length-r} of them ${s.length-r===1?"rests":"rest"}`,c=`${a}; ${l}.`;return o.length>0?`${o.join(", ").replace(/^./,u=>u.toUpperCase())}. ${c}`:c}function b0({pressing:t,stiffness:e,stretch:n,force:i,heldBack:s,squeezed:r,say:o}){if(r>.1)return"Squeezed: surfaces all around are nearer than the gap that is kept; move it back the way it came.";if(s>.01)return`Held back in ${Math.round(100*s)} % of the last second: the object waits where its contact model ends; move it more slowly.`;if(!(t>0)||!(e>0))return"Nothing limits the object but the coupling.";let a=e*n,l=`${o(e,"N/m")} × ${o(n,"m")}`;return i<.9*a?`The coupling alone limits the force: ${l} would be ${o(a,"N")}; it has levelled off, or the device is at its limit.`:`The coupling alone limits the force: ${l}. The surfaces do not give.`}function w0(t){return t.filter(({presses:e,friction:n,force:i,normal:s})=>{let r=i.reduce((a,l,c)=>a+l*s[c],0),o=Math.hypot(...i.map((a,l)=>a-r*s[l]));return e&&n>0&&o>.98*n*Math.abs(r)}).length}var qA=["what a hand feels","speed","what the eye sees","the cap on deviation","the budget"];function E0(t){return qA.map((i,s)=>[i,t.filter(r=>r.decidedBy===s).length]).filter(([,i])=>i>0).sort(([,i],[,s])=>s-i).map(([i,s])=>`${Math.round(100*s/t.length)} % by ${i}`).join(", ")}function vd(t){let e=new Map;for(let{objectLevel:n}of t)e.set(n,(e.get(n)??0)+1);return[...e].sort(([n],[i])=>n-i)}function A0(t){return t.length>0?[...t.map(({ending:e})=>e),".tex",".mcap"].join(","):""}function T0(t){return`Drop meshes${t.length>0?` (${t.map(({name:n})=>n).join(", ")})`:""}, a texture (.tex), or a recording or a scene in one file (.mcap) anywhere on the page, or click to choose.`}function C0(t){let e=document.getElementById("controls"),n=document.getElementById("view-tools"),i={title:document.getElementById("title"),chip:document.getElementById("state"),open:Zn("open","Open a scene or a mesh","O",t.open),pause:Zn("pause","Pause","P",t.pause),step:Zn("step","One step",".",t.step),reset:Zn("reset","Begin again","R",t.reset),record:Zn("record","Record","",t.record),theme:Zn("theme","Light or dark","",t.theme),help:Zn("help","Help","?",t.help),device:document.createElement("select"),views:{},headset:{},act:t};i.device.title="Who moves the object",i.device.setAttribute("aria-label",i.device.title),i.device.addEventListener("change",()=>t.device(i.device.value));let s=(...o)=>{let a=Object.assign(document.createElement("span"),{className:"group"});return a.append(...o),a};e.append(s(i.open),s(i.device),s(i.pause,i.step,i.reset,i.record),s(i.theme,i.help));let r=[["levels","Levels of detail: finest as wireframe","L","wireframe"],["ghost","Ghost of the hand","G","ghost"],["contacts","Contacts and clusters","C","contacts"],["forces","Force and torque","A","forces"],["names","Names of the objects","N","names"]];for(let[o,a,l,c]of r)i.views[c]=Zn(o,a,l,()=>t.view(c)),n.append(i.views[c]);return i.sound=Zn("sound","Sound of contact","S",t.sound),Sd(i,!1),n.append(Zn("add","Another body like the one touched last","",t.add),Zn("remove","Take the body touched last away","",t.remove)),n.append(i.sound,Zn("fit","Fit the view","F",t.fit)),i}function R0(t,e,n){for(let[i,s]of e)t.headset[i]=Zn(i==="immersive-ar"?"room":"headset",s,"",()=>n(i)),document.getElementById("view-tools").append(t.headset[i]);yd(t,null)}function yd(t,e){for(let[n,i]of Object.entries(t.headset))i.setAttribute("aria-pressed",String(n===e))}function Sd(t,e){t.sound.setAttribute("aria-pressed",String(e))}function Md(t,e){for(let[n,i]of Object.entries(t.views))i.setAttribute("aria-pressed",String(e[n]))}function P0(t,e){let{state:n,scene:i,shown:s,connected:r}=e;t.title.textContent=i?.title??"",document.title=i?`${i.title} · Thigma`:"Thigma";let o=r?n?.run??"connecting":"lost",a=s?` · ${Pr(s.time)}`:"",l={lost:"connection lost",connecting:"connecting",running:`running${a}`,paused:`paused${a}`,ended:e.progress?"preparing":xd[n?.reason]??"ended"};n?.late&&(l.running+=` · late ${n.late.count}×`);let c=o==="running"&&(s?.bits&4)!==0;n?.replay&&o==="running"&&(l.running=`replaying${a}`),t.chip.textContent=c?`forces off: ${Ir(e.faultName())}`:l[o],t.chip.title=o==="ended"?Hu(n)??"":n?.late?.text??"",t.chip.dataset.run=c?"fault":o;let u=r&&!!n,h=n?.run==="paused";al(t.pause,h?"play":"pause"),Fo(t.pause,h?"Go on":"Pause","P"),t.pause.disabled=!u||n.run==="ended",t.step.disabled=!u||!h,t.reset.disabled=t.record.disabled=!u,t.open.disabled=!u||!!i?.world;let f=!!n?.recording;al(t.record,f?"stop":"record"),t.record.classList.toggle("on",f),Fo(t.record,f?`Stop recording ${n.recording}`:"Record from the start",""),$A(t,n,u)}function $A(t,e,n){let i=[...new Set([...e?.devices??[],...e?[e.device]:[]])];t.device.dataset.uris!==i.join(" ")&&(t.device.dataset.uris=i.join(" "),t.device.replaceChildren(...i.map(s=>new Option(x0(s),s)))),t.device.hidden=i.length===0,t.device.disabled=!n||i.length<2,e&&document.activeElement!==t.device&&(t.device.value=e.device)}function I0(t,e){let n=e?`${e.text}|${e.button??""}`:"";if(t.dataset.key===n||(t.dataset.key=n,t.hidden=!e,!e))return;let i=Object.assign(document.createElement("span"),{textContent:e.text});if(t.className=`hint ${e.mood??""}`,t.replaceChildren(...e.icon?[Vu(e.icon)]:[],i),!e.button)return;let s=Object.assign(document.createElement("button"),{type:"button",textContent:e.button});s.addEventListener("click",e.act),t.append(s)}function L0(){return{step:0,turned:!1,unarmedSince:null,touchedAt:null}}function N0(t,e,n,i){let{state:s,scene:r,snapshot:o}=e;if(!e.connected||!s||!r||!o)return null;let a=r.object.name,l=(o.bits&32)!==0,c=(o.bits&1)!==0,u=(o.bits&2)!==0,h=(o.bits&4)!==0;if(e.progress)return null;let f=e.hello?.may_control===!1;if(s.run==="ended")return{text:`The session ${Hu(s)??"has ended"}.`,button:f?void 0:"Begin again",act:i.reset,mood:"stop"};if(e.refusal&&n.now<e.refusal.until)return{text:e.refusal.text,mood:"stop"};if(f)return{text:"This page watches. To do more, open the address with its token, as the program has printed it."};if(s.replay)return{text:`A recording: ${s.replay.file.split("/").pop()}`,button:s.devices.includes("web:")?"Take it yourself":void 0,act:()=>i.device("web:")};if(h){let g=s.device.startsWith("web:");return{text:`Forces are off: ${Ir(e.faultName())}.${g?` Take hold of the ${a} again to go on.`:""}`,button:g?void 0:"Begin again",act:i.reset,mood:"stop"}}let d=v0(s.late,o.time);return d?{text:d,mood:"stop"}:s.device.startsWith("web:")?s.holder==="other"?{text:"Another page holds the hand; this one watches."}:r.world?YA(n):ZA(t,{object:a,grasped:c,armed:u,fading:l,snapshot:o,scene:r,...n}):s.devices.includes("web:")?{text:`A ${s.simulated===!1?"device":"simulated hand"} moves the ${a}.`,button:"Take it yourself",act:()=>i.device("web:"),icon:"hand"}:null}function YA({holding:t,touch:e}){return t?{text:e?"Two fingers turn it; spread them to move it away.":"Shift-drag or the wheel moves it away, Ctrl-drag turns it."}:{text:e?"Touch a body and drag it; let go to drop or throw it.":"Press on a body and drag it; let go to drop or throw it.",icon:"hand"}}function ZA(t,e){let{object:n,grasped:i,armed:s,now:r,newtons:o}=e;if(!i||!e.holding)return t.unarmedSince=null,{text:`Drag the blue ${n}.`,icon:"hand"};if(s?t.unarmedSince=null:t.unarmedSince??=r,!s&&r-t.unarmedSince>.6)return{text:`Taken hold of inside a contact: lift the ${n} off once, then forces come on.`};if(e.fading)return{text:"This page is slow: the force fades until it keeps up, and comes back by itself."};if(o>0&&(t.touchedAt??=r),t.touchedAt===null){let a=e.scene.statics[0]?.name??"scene",l=e.touch?"spread two fingers to move it away":"Shift-drag or the wheel moves it deeper";return{text:`Press it against the ${a}: ${l}. The arrow will be the force in your hand.`}}return!t.turned&&e.turned&&(t.turned=!0),!t.turned&&r-t.touchedAt<12?{text:e.touch?"Two fingers turn it. A finger beside it turns the view.":"Ctrl-drag turns it. Space lets go. Right-drag turns the view."}:null}var Lr={grasped:1,armed:2,fault:4,paused:8,ended:16,fading:32,heldBack:64,squeezed:128,constrained:256};var bd=64;var ll=16,jA=48,Xu=48;var D0=32,JA=64,cl=class extends Error{},fn=(t,e)=>{if(!t)throw new cl(e)};function U0(t){fn(t.byteLength>=ll,`a message of ${t.byteLength} bytes has no header`);let e=new DataView(t),n=e.getUint8(0),i=e.getUint8(1),s={bits:e.getUint16(2,!0),count:e.getUint32(4,!0),time:e.getFloat64(8,!0)},r={1:KA,2:tT,3:nT,4:QA,5:eT,6:iT};return fn(r[n],`message type ${n} is not known`),fn(i===1,`layout ${i} of message type ${n} is not known`),r[n](t,e,s)}function Oo(t,e,n){fn(t.byteLength===e,`${n} of ${t.byteLength} bytes, ${e} expected`)}function wd(t,e){let n=e;return(i,s)=>{let r=new i(t,n,s);return n+=4*s,r}}function Ed({positions:t,triangles:e,patchOfTriangle:n},i,s,r){fn(t.every(Number.isFinite),`${r} with a position that is no number`),fn(e.every(o=>o<i),`${r} with a triangle of a vertex that is not there`),fn(n.every(o=>o<s||o===4294967295),`${r} with a triangle of a patch that is not there`)}function KA(t,e,{count:n}){fn(t.byteLength>=32,`mesh of ${t.byteLength} bytes, 32 at least`);let[i,s,r,o]=[16,20,24,28].map(c=>e.getUint32(c,!0));Oo(t,32+12*i+16*s+4*r+8*o,"mesh");let a=wd(t,32),l={kind:"mesh",number:n,positions:a(Float32Array,3*i),triangles:a(Uint32Array,3*s),patchOfTriangle:a(Uint32Array,s),nodeOfPatch:a(Int32Array,r),parents:a(Int32Array,o),levels:a(Int32Array,o)};return Ed(l,i,r,"mesh"),fn(l.nodeOfPatch.every(c=>c>=0&&c<o),"mesh with a patch of a node that is not there"),fn(l.parents.every(c=>c>=-1&&c<o),"mesh with a parent that is not there"),fn(l.levels.every(c=>c>=0),"mesh with a negative level"),l}function QA(t,e,{bits:n,count:i}){fn(t.byteLength>=32,`level of ${t.byteLength} bytes, 32 at least`);let[s,r,o]=[16,20,24].map(c=>e.getUint32(c,!0));Oo(t,32+12*s+16*r+4*o,"level");let a=wd(t,32),l={kind:"level",number:i,level:n,positions:a(Float32Array,3*s),triangles:a(Uint32Array,3*r),patchOfTriangle:a(Uint32Array,r),nodeOfPatch:a(Int32Array,o)};return fn(n>0,"level 0 comes as a mesh"),Ed(l,s,o,"level"),fn(l.nodeOfPatch.every(c=>c>=-1),"level with a patch of no node that could be"),l}function eT(t,e,{count:n}){fn(t.byteLength>=32,`relief of ${t.byteLength} bytes, 32 at least`);let[i,s,r]=[16,20,24].map(l=>e.getUint32(l,!0));Oo(t,32+12*i+16*s,"relief");let o=wd(t,32),a={kind:"relief",number:n,patches:r,positions:o(Float32Array,3*i),triangles:o(Uint32Array,3*s),patchOfTriangle:o(Uint32Array,s)};return Ed(a,i,r,"relief"),a}function tT(t,e,{bits:n,count:i,time:s}){return fn(n>0,"channels without a column"),fn(Number.isFinite(s),"channels without a time"),Oo(t,ll+4*n*i,"channels"),{kind:"channels",columns:n,rows:i,time:s,values:new Float32Array(t,ll,n*i)}}function nT(t,e,{bits:n,count:i,time:s}){fn(t.byteLength>=240,`snapshot of ${t.byteLength} bytes, 240 at least`);let r=e.getUint32(216,!0),o=e.getUint32(236,!0);Oo(t,240+Xu*(i+r+o),"snapshot");let a=new Float32Array(t,24,jA),l=h=>[a[h],a[h+1],a[h+2]],c=h=>({position:l(h),quaternion:[a[h+3],a[h+4],a[h+5],a[h+6]]}),u={kind:"snapshot",time:s,bits:n,frame:e.getFloat64(16,!0),object:c(0),ghost:c(7),handle:c(14),grasp:l(21),force:l(24),torque:l(27),contactForce:l(30),contactTorque:l(33),center:l(36),penetration:a[39],stretch:a[40],energy:a[41],modelAge:a[42],modelWeight:a[43],hapticRate:a[44],contactRate:a[45],queryCpu:a[46],metresPerNewton:a[47],contactsFound:e.getUint32(220,!0),contactsDropped:e.getUint32(224,!0),front:e.getUint32(228,!0),fault:e.getUint32(232,!0),contacts:[],clusters:[],rows:[]};fn(a.subarray(0,24).every(Number.isFinite),"snapshot with a pose that is no number");for(let h=0;h<i;h++)u.contacts.push(sT(e,240+Xu*h));for(let h=0;h<r;h++)u.clusters.push(rT(e,240+Xu*(i+h)));for(let h=0;h<o;h++)u.rows.push(oT(e,240+Xu*(i+r+h)));return u}function iT(t,e,{count:n,time:i}){fn(t.byteLength>=32,`bodies of ${t.byteLength} bytes, 32 at least`);let s=e.getUint32(24,!0);Oo(t,32+D0*n+JA*s,"bodies");let r=new Float32Array(t,32,8*n+16*s),o=l=>({position:[r[l],r[l+1],r[l+2]],quaternion:[r[l+3],r[l+4],r[l+5],r[l+6]]}),a={kind:"bodies",time:i,frame:e.getFloat64(16,!0),bodies:[],hands:[]};for(let l=0;l<n;l++)fn(r.subarray(8*l,8*l+7).every(Number.isFinite),"bodies with a pose that is no number"),a.bodies.push({...o(8*l),asleep:(e.getUint32(32+D0*l+28,!0)&1)!==0});for(let l=0;l<s;l++){let c=8*n+16*l,u=32+4*c;a.hands.push({handle:o(c),grasp:[r[c+7],r[c+8],r[c+9]],force:[r[c+10],r[c+11],r[c+12]],body:e.getInt32(u+52,!0),page:(e.getUint32(u+56,!0)&1)!==0})}return a}var ur=(t,e,n)=>Array.from({length:n},(i,s)=>t.getFloat32(e+4*s,!0));function sT(t,e){let n=t.getUint32(e+44,!0);return{point:ur(t,e,3),normal:ur(t,e+12,3),depth:t.getFloat32(e+24,!0),bound:t.getFloat32(e+28,!0),body:t.getInt32(e+32,!0),objectNode:t.getInt32(e+36,!0),sceneNode:t.getInt32(e+40,!0),objectLevel:n&255,sceneLevel:n>>8&255,status:n>>16&255,decidedBy:n>>>24}}function rT(t,e){return{point:ur(t,e,3),normal:ur(t,e+12,3),depth:t.getFloat32(e+24,!0),force:ur(t,e+28,3),id:t.getInt32(e+40,!0)}}function oT(t,e){let n=t.getUint32(e+44,!0);return{point:ur(t,e,3),normal:ur(t,e+12,3),gap:t.getFloat32(e+24,!0),force:ur(t,e+28,3),friction:t.getFloat32(e+40,!0),kind:n&3,presses:(n&4)!==0}}function F0(t){let e=null;try{e=JSON.parse(t)}catch{}return fn(e&&typeof e=="object"&&typeof e.type=="string","a text message without a type"),e}function O0(t){let e=new ArrayBuffer(ll+t.length),n=new DataView(e);return n.setUint8(0,33),n.setUint8(1,1),n.setUint32(4,t.length,!0),new Uint8Array(e,ll).set(t),e}var Ad=.004,B0=9.9;function k0(){return{position:[0,0,0],quaternion:[0,0,0,1],clutch:!1,pending:[],latest:-1/0}}function vi(t,e){return[t[3]*e[0]+t[0]*e[3]+t[1]*e[2]-t[2]*e[1],t[3]*e[1]-t[0]*e[2]+t[1]*e[3]+t[2]*e[0],t[3]*e[2]+t[0]*e[1]-t[1]*e[0]+t[2]*e[3],t[3]*e[3]-t[0]*e[0]-t[1]*e[1]-t[2]*e[2]]}var Nr=t=>[-t[0],-t[1],-t[2],t[3]];function ul(t,e){let[n,i,s]=vi(vi(t,[...e,0]),Nr(t));return[n,i,s]}function qu(t,e){let n=Math.sin(.5*e);return[n*t[0],n*t[1],n*t[2],Math.cos(.5*e)]}function $u(t,e,n){let i=ul(Nr(n.quat_xyzw),e);t.position=t.position.map((s,r)=>Math.max(-B0,Math.min(B0,s+i[r]/n.motion_scale)))}var Yu=(t,e,n,i)=>Td(t,qu(e,n),i);function Td(t,e,n){let i=n.quat_xyzw,s=vi(vi(vi(Nr(i),e),i),t.quaternion),r=Math.hypot(...s);t.quaternion=s.map(o=>o/r)}function lT(t,e,n=-1/0){let i=t[t.length-1],s=t[t.length-2]?.time??n;i&&i.buttons===e.buttons&&i.time-s<Ad?t[t.length-1]=e:t.push(e),t.length>bd&&t.splice(0,t.length-bd)}var Cd=t=>({position:[...t.position],quaternion:[...t.quaternion]});function hr(t,e,n=Cd(t)){let i={time:Math.max(e,t.latest),...n,buttons:t.clutch?1:0};lT(t.pending,i,t.sent),t.latest=i.time}function Zu(t){let e=t.pending;return t.pending=[],e.length>0&&(t.sent=e[e.length-1].time),e}var Dr=new Ns,dn=new F,fr=new F,tn=new Tt,z0={X:new F(1,0,0),Y:new F(0,1,0),Z:new F(0,0,1)},Rd={type:"change"},G0={type:"mouseDown",mode:null},V0={type:"mouseUp",mode:null},H0={type:"objectChange"},eh=class extends Va{constructor(e,n=null){super(void 0,n);let i=new Id(this);this._root=i;let s=new Ld;this._gizmo=s,i.add(s);let r=new Nd;this._plane=r,i.add(r);let o=this;function a(T,S){let C=S;Object.defineProperty(o,T,{get:function(){return C!==void 0?C:S},set:function(A){C!==A&&(C=A,r[T]=A,s[T]=A,o.dispatchEvent({type:T+"-changed",value:A}),o.dispatchEvent(Rd))}}),o[T]=S,r[T]=S,s[T]=S}a("camera",e),a("object",void 0),a("enabled",!0),a("axis",null),a("mode","translate"),a("translationSnap",null),a("rotationSnap",null),a("scaleSnap",null),a("space","world"),a("size",1),this.viewport=null,a("dragging",!1),a("showX",!0),a("showY",!0),a("showZ",!0),a("showXY",!0),a("showYZ",!0),a("showXZ",!0),a("showXYZE",!0),a("showE",!0),a("minX",-1/0),a("maxX",1/0),a("minY",-1/0),a("maxY",1/0),a("minZ",-1/0),a("maxZ",1/0);let l=new F,c=new F,u=new Tt,h=new Tt,f=new F,d=new Tt,g=new F,y=new F,p=new F,m=0,v=new F;a("worldPosition",l),a("worldPositionStart",c),a("worldQuaternion",u),a("worldQuaternionStart",h),a("cameraPosition",f),a("cameraQuaternion",d),a("pointStart",g),a("pointEnd",y),a("rotationAxis",p),a("rotationAngle",m),a("eye",v),this._offset=new F,this._startNorm=new F,this._endNorm=new F,this._cameraScale=new F,this._parentPosition=new F,this._parentQuaternion=new Tt,this._parentQuaternionInv=new Tt,this._parentScale=new F,this._worldScaleStart=new F,this._worldQuaternionInv=new Tt,this._worldScale=new F,this._positionStart=new F,this._quaternionStart=new Tt,this._scaleStart=new F,this._getPointer=cT.bind(this),this._onPointerDown=hT.bind(this),this._onPointerHover=uT.bind(this),this._onPointerMove=fT.bind(this),this._onPointerUp=dT.bind(this),n!==null&&this.connect(n)}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointermove",this._onPointerHover),this.domElement.addEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerHover),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction=""}getHelper(){return this._root}pointerHover(e){if(this.object===void 0||this.dragging===!0)return;e!==null&&Dr.setFromCamera(e,this.camera);let n=Pd(this._gizmo.picker[this.mode],Dr);n?this.axis=n.object.name:this.axis=null}pointerDown(e){if(!(this.object===void 0||this.dragging===!0||e!=null&&e.button!==0)&&this.axis!==null){e!==null&&Dr.setFromCamera(e,this.camera);let n=Pd(this._plane,Dr,!0);n&&(this.object.updateMatrixWorld(),this.object.parent.updateMatrixWorld(),this._positionStart.copy(this.object.position),this._quaternionStart.copy(this.object.quaternion),this._scaleStart.copy(this.object.scale),this.object.matrixWorld.decompose(this.worldPositionStart,this.worldQuaternionStart,this._worldScaleStart),this.pointStart.copy(n.point).sub(this.worldPositionStart)),this.dragging=!0,G0.mode=this.mode,this.dispatchEvent(G0)}}pointerMove(e){let n=this.axis,i=this.mode,s=this.object,r=this.space;if(i==="scale"?r="local":(n==="E"||n==="XYZE"||n==="XYZ")&&(r="world"),s===void 0||n===null||this.dragging===!1||e!==null&&e.button!==-1)return;e!==null&&Dr.setFromCamera(e,this.camera);let o=Pd(this._plane,Dr,!0);if(o){if(this.pointEnd.copy(o.point).sub(this.worldPositionStart),i==="translate")this._offset.copy(this.pointEnd).sub(this.pointStart),r==="local"&&n!=="XYZ"&&this._offset.applyQuaternion(this._worldQuaternionInv),n.indexOf("X")===-1&&(this._offset.x=0),n.indexOf("Y")===-1&&(this._offset.y=0),n.indexOf("Z")===-1&&(this._offset.z=0),r==="local"&&n!=="XYZ"?this._offset.applyQuaternion(this._quaternionStart).divide(this._parentScale):this._offset.applyQuaternion(this._parentQuaternionInv).divide(this._parentScale),s.position.copy(this._offset).add(this._positionStart),this.translationSnap&&(r==="local"&&(s.position.applyQuaternion(tn.copy(this._quaternionStart).invert()),n.search("X")!==-1&&(s.position.x=Math.round(s.position.x/this.translationSnap)*this.translationSnap),n.search("Y")!==-1&&(s.position.y=Math.round(s.position.y/this.translationSnap)*this.translationSnap),n.search("Z")!==-1&&(s.position.z=Math.round(s.position.z/this.translationSnap)*this.translationSnap),s.position.applyQuaternion(this._quaternionStart)),r==="world"&&(s.getWorldPosition(dn),n.search("X")!==-1&&(dn.x=Math.round(dn.x/this.translationSnap)*this.translationSnap),n.search("Y")!==-1&&(dn.y=Math.round(dn.y/this.translationSnap)*this.translationSnap),n.search("Z")!==-1&&(dn.z=Math.round(dn.z/this.translationSnap)*this.translationSnap),s.position.copy(s.parent.worldToLocal(dn)))),s.position.x=Math.max(this.minX,Math.min(this.maxX,s.position.x)),s.position.y=Math.max(this.minY,Math.min(this.maxY,s.position.y)),s.position.z=Math.max(this.minZ,Math.min(this.maxZ,s.position.z));else if(i==="scale"){if(n.search("XYZ")!==-1){let a=this.pointEnd.length()/this.pointStart.length();this.pointEnd.dot(this.pointStart)<0&&(a*=-1),fr.set(a,a,a)}else dn.copy(this.pointStart),fr.copy(this.pointEnd),dn.applyQuaternion(this._worldQuaternionInv),fr.applyQuaternion(this._worldQuaternionInv),fr.divide(dn),n.search("X")===-1&&(fr.x=1),n.search("Y")===-1&&(fr.y=1),n.search("Z")===-1&&(fr.z=1);s.scale.copy(this._scaleStart).multiply(fr),this.scaleSnap&&(n.search("X")!==-1&&(s.scale.x=Math.round(s.scale.x/this.scaleSnap)*this.scaleSnap||this.scaleSnap),n.search("Y")!==-1&&(s.scale.y=Math.round(s.scale.y/this.scaleSnap)*this.scaleSnap||this.scaleSnap),n.search("Z")!==-1&&(s.scale.z=Math.round(s.scale.z/this.scaleSnap)*this.scaleSnap||this.scaleSnap))}else if(i==="rotate"){this._offset.copy(this.pointEnd).sub(this.pointStart);let a=20/this.worldPosition.distanceTo(dn.setFromMatrixPosition(this.camera.matrixWorld)),l=!1;n==="XYZE"?(this.rotationAxis.copy(this._offset).cross(this.eye).normalize(),this.rotationAngle=this._offset.dot(dn.copy(this.rotationAxis).cross(this.eye))*a):(n==="X"||n==="Y"||n==="Z")&&(this.rotationAxis.copy(z0[n]),dn.copy(z0[n]),r==="local"&&dn.applyQuaternion(this.worldQuaternion),dn.cross(this.eye),dn.length()===0?l=!0:this.rotationAngle=this._offset.dot(dn.normalize())*a),(n==="E"||l)&&(this.rotationAxis.copy(this.eye),this.rotationAngle=this.pointEnd.angleTo(this.pointStart),this._startNorm.copy(this.pointStart).normalize(),this._endNorm.copy(this.pointEnd).normalize(),this.rotationAngle*=this._endNorm.cross(this._startNorm).dot(this.eye)<0?1:-1),this.rotationSnap&&(this.rotationAngle=Math.round(this.rotationAngle/this.rotationSnap)*this.rotationSnap),r==="local"&&n!=="E"&&n!=="XYZE"?(s.quaternion.copy(this._quaternionStart),s.quaternion.multiply(tn.setFromAxisAngle(this.rotationAxis,this.rotationAngle)).normalize()):(this.rotationAxis.applyQuaternion(this._parentQuaternionInv),s.quaternion.copy(tn.setFromAxisAngle(this.rotationAxis,this.rotationAngle)),s.quaternion.multiply(this._quaternionStart).normalize())}this.dispatchEvent(Rd),this.dispatchEvent(H0)}}pointerUp(e){e!==null&&e.button!==0||(this.dragging&&this.axis!==null&&(V0.mode=this.mode,this.dispatchEvent(V0)),this.dragging=!1,this.axis=null)}dispose(){this.disconnect(),this._root.dispose()}attach(e){return this.object=e,this._root.visible=!0,this}detach(){return this.object=void 0,this.axis=null,this._root.visible=!1,this}reset(){this.enabled&&this.dragging&&(this.object.position.copy(this._positionStart),this.object.quaternion.copy(this._quaternionStart),this.object.scale.copy(this._scaleStart),this.dispatchEvent(Rd),this.dispatchEvent(H0),this.pointStart.copy(this.pointEnd))}getRaycaster(){return Dr}getMode(){return this.mode}setMode(e){this.mode=e}setTranslationSnap(e){this.translationSnap=e}setRotationSnap(e){this.rotationSnap=e}setScaleSnap(e){this.scaleSnap=e}setSize(e){this.size=e}setSpace(e){this.space=e}setColors(e,n,i,s){let r=this._gizmo.materialLib;r.xAxis.color.set(e),r.yAxis.color.set(n),r.zAxis.color.set(i),r.active.color.set(s),r.xAxisTransparent.color.set(e),r.yAxisTransparent.color.set(n),r.zAxisTransparent.color.set(i),r.activeTransparent.color.set(s),r.xAxis._color&&r.xAxis._color.set(e),r.yAxis._color&&r.yAxis._color.set(n),r.zAxis._color&&r.zAxis._color.set(i),r.active._color&&r.active._color.set(s),r.xAxisTransparent._color&&r.xAxisTransparent._color.set(e),r.yAxisTransparent._color&&r.yAxisTransparent._color.set(n),r.zAxisTransparent._color&&r.zAxisTransparent._color.set(i),r.activeTransparent._color&&r.activeTransparent._color.set(s)}};function cT(t){if(this.domElement.ownerDocument.pointerLockElement)return{x:0,y:0,button:t.button};{let e=this.domElement.getBoundingClientRect(),n=this.viewport,i,s,r,o;return n!==null?(i=n.x,s=e.height-n.y-n.w,r=n.z,o=n.w):(i=0,s=0,r=e.width,o=e.height),{x:(t.clientX-e.left-i)/r*2-1,y:-(t.clientY-e.top-s)/o*2+1,button:t.button}}}function uT(t){if(this.enabled)switch(t.pointerType){case"mouse":case"pen":this.pointerHover(this._getPointer(t));break}}function hT(t){this.enabled&&(document.pointerLockElement||this.domElement.setPointerCapture(t.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.pointerHover(this._getPointer(t)),this.pointerDown(this._getPointer(t)))}function fT(t){this.enabled&&this.pointerMove(this._getPointer(t))}function dT(t){this.enabled&&(this.domElement.releasePointerCapture(t.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.pointerUp(this._getPointer(t)))}function Pd(t,e,n){let i=e.intersectObject(t,!0);for(let s=0;s<i.length;s++)if(i[s].object.visible||n)return i[s];return!1}var ju=new Ci,Bt=new F(0,1,0),W0=new F(0,0,0),X0=new Dt,Ju=new Tt,Qu=new Tt,ps=new F,th=new Dt,dl=new F(1,0,0),Ur=new F(0,1,0),pl=new F(0,0,1),Ku=new F,hl=new F,fl=new F,Id=class extends gn{constructor(e){super(),this.isTransformControlsRoot=!0,this.controls=e,this.visible=!1}updateMatrixWorld(e){let n=this.controls;n.object!==void 0&&(n.object.updateMatrixWorld(),n.object.parent===null?console.error("TransformControls: The attached 3D object must be a part of the scene graph."):n.object.parent.matrixWorld.decompose(n._parentPosition,n._parentQuaternion,n._parentScale),n.object.matrixWorld.decompose(n.worldPosition,n.worldQuaternion,n._worldScale),n._parentQuaternionInv.copy(n._parentQuaternion).invert(),n._worldQuaternionInv.copy(n.worldQuaternion).invert()),n.camera.updateMatrixWorld(),n.camera.matrixWorld.decompose(n.cameraPosition,n.cameraQuaternion,n._cameraScale),n.camera.isOrthographicCamera?n.camera.getWorldDirection(n.eye).negate():n.eye.copy(n.cameraPosition).sub(n.worldPosition).normalize(),this.parent&&(th.copy(this.parent.matrixWorld).invert(),th.decompose(this.position,this.quaternion,this.scale)),super.updateMatrixWorld(e)}dispose(){this.traverse(function(e){e.geometry&&e.geometry.dispose(),e.material&&e.material.dispose()})}},Ld=class extends gn{constructor(){super(),this.isTransformControlsGizmo=!0,this.type="TransformControlsGizmo";let e=new Rs({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),n=new ir({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),i=e.clone();i.opacity=.15;let s=n.clone();s.opacity=.5;let r=e.clone();r.color.setHex(16711680);let o=e.clone();o.color.setHex(65280);let a=e.clone();a.color.setHex(255);let l=e.clone();l.color.setHex(16711680),l.opacity=.5;let c=e.clone();c.color.setHex(65280),c.opacity=.5;let u=e.clone();u.color.setHex(255),u.opacity=.5;let h=e.clone();h.opacity=.25;let f=e.clone();f.color.setHex(16776960),f.opacity=.25;let d=e.clone();d.color.setHex(16776960);let g=e.clone();g.color.setHex(7895160),this.materialLib={xAxis:r,yAxis:o,zAxis:a,active:d,xAxisTransparent:l,yAxisTransparent:c,zAxisTransparent:u,activeTransparent:f};let y=new Wt(0,.04,.1,12);y.translate(0,.05,0);let p=new hn(.08,.08,.08);p.translate(0,.04,0);let m=new jt;m.setAttribute("position",new wt([0,0,0,1,0,0],3));let v=new Wt(.0075,.0075,.5,3);v.translate(0,.25,0);function T(z,$){let V=new Xi(z,.0075,3,64,$*Math.PI*2);return V.rotateY(Math.PI/2),V.rotateX(Math.PI/2),V}function S(){let z=new jt;return z.setAttribute("position",new wt([0,0,0,1,1,1],3)),z}let C={X:[[new Me(y,r),[.5,0,0],[0,0,-Math.PI/2]],[new Me(y,r),[-.5,0,0],[0,0,Math.PI/2]],[new Me(v,r),[0,0,0],[0,0,-Math.PI/2]]],Y:[[new Me(y,o),[0,.5,0]],[new Me(y,o),[0,-.5,0],[Math.PI,0,0]],[new Me(v,o)]],Z:[[new Me(y,a),[0,0,.5],[Math.PI/2,0,0]],[new Me(y,a),[0,0,-.5],[-Math.PI/2,0,0]],[new Me(v,a),null,[Math.PI/2,0,0]]],XYZ:[[new Me(new sr(.1,0),h),[0,0,0]]],XY:[[new Me(new hn(.15,.15,.01),u),[.15,.15,0]]],YZ:[[new Me(new hn(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Me(new hn(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]]},A={X:[[new Me(new Wt(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new Me(new Wt(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new Me(new Wt(.2,0,.6,4),i),[0,.3,0]],[new Me(new Wt(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new Me(new Wt(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new Me(new Wt(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XYZ:[[new Me(new sr(.2,0),i)]],XY:[[new Me(new hn(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new Me(new hn(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Me(new hn(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]]},_={START:[[new Me(new sr(.01,2),s),null,null,null,"helper"]],END:[[new Me(new sr(.01,2),s),null,null,null,"helper"]],DELTA:[[new _i(S(),s),null,null,null,"helper"]],X:[[new _i(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new _i(m,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new _i(m,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]},w={XYZE:[[new Me(T(.5,1),g),null,[0,Math.PI/2,0]]],X:[[new Me(T(.5,.5),r)]],Y:[[new Me(T(.5,.5),o),null,[0,0,-Math.PI/2]]],Z:[[new Me(T(.5,.5),a),null,[0,Math.PI/2,0]]],E:[[new Me(T(.75,1),f),null,[0,Math.PI/2,0]]]},U={AXIS:[[new _i(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]]},L={XYZE:[[new Me(new us(.25,10,8),i)]],X:[[new Me(new Xi(.5,.1,4,24),i),[0,0,0],[0,-Math.PI/2,-Math.PI/2]]],Y:[[new Me(new Xi(.5,.1,4,24),i),[0,0,0],[Math.PI/2,0,0]]],Z:[[new Me(new Xi(.5,.1,4,24),i),[0,0,0],[0,0,-Math.PI/2]]],E:[[new Me(new Xi(.75,.1,2,24),i)]]},N={X:[[new Me(p,r),[.5,0,0],[0,0,-Math.PI/2]],[new Me(v,r),[0,0,0],[0,0,-Math.PI/2]],[new Me(p,r),[-.5,0,0],[0,0,Math.PI/2]]],Y:[[new Me(p,o),[0,.5,0]],[new Me(v,o)],[new Me(p,o),[0,-.5,0],[0,0,Math.PI]]],Z:[[new Me(p,a),[0,0,.5],[Math.PI/2,0,0]],[new Me(v,a),[0,0,0],[Math.PI/2,0,0]],[new Me(p,a),[0,0,-.5],[-Math.PI/2,0,0]]],XY:[[new Me(new hn(.15,.15,.01),u),[.15,.15,0]]],YZ:[[new Me(new hn(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Me(new hn(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new Me(new hn(.1,.1,.1),h)]]},k={X:[[new Me(new Wt(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new Me(new Wt(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new Me(new Wt(.2,0,.6,4),i),[0,.3,0]],[new Me(new Wt(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new Me(new Wt(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new Me(new Wt(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XY:[[new Me(new hn(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new Me(new hn(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new Me(new hn(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new Me(new hn(.2,.2,.2),i),[0,0,0]]]},H={X:[[new _i(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new _i(m,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new _i(m,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]};function I(z){let $=new gn;for(let V in z)for(let ae=z[V].length;ae--;){let q=z[V][ae][0].clone(),K=z[V][ae][1],ne=z[V][ae][2],he=z[V][ae][3],fe=z[V][ae][4];q.name=V,q.tag=fe,K&&q.position.set(K[0],K[1],K[2]),ne&&q.rotation.set(ne[0],ne[1],ne[2]),he&&q.scale.set(he[0],he[1],he[2]),q.updateMatrix();let Q=q.geometry.clone();Q.applyMatrix4(q.matrix),q.geometry=Q,q.renderOrder=1/0,q.position.set(0,0,0),q.rotation.set(0,0,0),q.scale.set(1,1,1),$.add(q)}return $}this.gizmo={},this.picker={},this.helper={},this.add(this.gizmo.translate=I(C)),this.add(this.gizmo.rotate=I(w)),this.add(this.gizmo.scale=I(N)),this.add(this.picker.translate=I(A)),this.add(this.picker.rotate=I(L)),this.add(this.picker.scale=I(k)),this.add(this.helper.translate=I(_)),this.add(this.helper.rotate=I(U)),this.add(this.helper.scale=I(H)),this.picker.translate.visible=!1,this.picker.rotate.visible=!1,this.picker.scale.visible=!1}updateMatrixWorld(e){let i=(this.mode==="scale"?"local":this.space)==="local"?this.worldQuaternion:Qu;this.gizmo.translate.visible=this.mode==="translate",this.gizmo.rotate.visible=this.mode==="rotate",this.gizmo.scale.visible=this.mode==="scale",this.helper.translate.visible=this.mode==="translate",this.helper.rotate.visible=this.mode==="rotate",this.helper.scale.visible=this.mode==="scale";let s=[];s=s.concat(this.picker[this.mode].children),s=s.concat(this.gizmo[this.mode].children),s=s.concat(this.helper[this.mode].children);for(let r=0;r<s.length;r++){let o=s[r];o.visible=!0,o.rotation.set(0,0,0),o.position.copy(this.worldPosition);let a;if(this.camera.isOrthographicCamera?a=(this.camera.top-this.camera.bottom)/this.camera.zoom:a=this.worldPosition.distanceTo(this.cameraPosition)*Math.min(1.9*Math.tan(Math.PI*this.camera.fov/360)/this.camera.zoom,7),o.scale.set(1,1,1).multiplyScalar(a*this.size/4),o.tag==="helper"){o.visible=!1,o.name==="AXIS"?(o.visible=!!this.axis,this.axis==="X"&&(tn.setFromEuler(ju.set(0,0,0)),o.quaternion.copy(i).multiply(tn),Math.abs(Bt.copy(dl).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Y"&&(tn.setFromEuler(ju.set(0,0,Math.PI/2)),o.quaternion.copy(i).multiply(tn),Math.abs(Bt.copy(Ur).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Z"&&(tn.setFromEuler(ju.set(0,Math.PI/2,0)),o.quaternion.copy(i).multiply(tn),Math.abs(Bt.copy(pl).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="XYZE"&&(tn.setFromEuler(ju.set(0,Math.PI/2,0)),Bt.copy(this.rotationAxis),o.quaternion.setFromRotationMatrix(X0.lookAt(W0,Bt,Ur)),o.quaternion.multiply(tn),o.visible=this.dragging),this.axis==="E"&&(o.visible=!1)):o.name==="START"?(o.position.copy(this.worldPositionStart),o.visible=this.dragging):o.name==="END"?(o.position.copy(this.worldPosition),o.visible=this.dragging):o.name==="DELTA"?(o.position.copy(this.worldPositionStart),o.quaternion.copy(this.worldQuaternionStart),dn.set(1e-10,1e-10,1e-10).add(this.worldPositionStart).sub(this.worldPosition).multiplyScalar(-1),dn.applyQuaternion(this.worldQuaternionStart.clone().invert()),o.scale.copy(dn),o.visible=this.dragging):(o.quaternion.copy(i),this.dragging?o.position.copy(this.worldPositionStart):o.position.copy(this.worldPosition),this.axis&&(o.visible=this.axis.search(o.name)!==-1));continue}o.quaternion.copy(i),this.mode==="translate"||this.mode==="scale"?(o.name==="X"&&Math.abs(Bt.copy(dl).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Y"&&Math.abs(Bt.copy(Ur).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Z"&&Math.abs(Bt.copy(pl).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XY"&&Math.abs(Bt.copy(pl).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="YZ"&&Math.abs(Bt.copy(dl).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XZ"&&Math.abs(Bt.copy(Ur).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1)):this.mode==="rotate"&&(Ju.copy(i),Bt.copy(this.eye).applyQuaternion(tn.copy(i).invert()),o.name.search("E")!==-1&&o.quaternion.setFromRotationMatrix(X0.lookAt(this.eye,W0,Ur)),o.name==="X"&&(tn.setFromAxisAngle(dl,Math.atan2(-Bt.y,Bt.z)),tn.multiplyQuaternions(Ju,tn),o.quaternion.copy(tn)),o.name==="Y"&&(tn.setFromAxisAngle(Ur,Math.atan2(Bt.x,Bt.z)),tn.multiplyQuaternions(Ju,tn),o.quaternion.copy(tn)),o.name==="Z"&&(tn.setFromAxisAngle(pl,Math.atan2(Bt.y,Bt.x)),tn.multiplyQuaternions(Ju,tn),o.quaternion.copy(tn))),o.visible=o.visible&&(o.name.indexOf("X")===-1||this.showX),o.visible=o.visible&&(o.name.indexOf("Y")===-1||this.showY),o.visible=o.visible&&(o.name.indexOf("Z")===-1||this.showZ),o.visible=o.visible&&(o.name.indexOf("E")===-1||this.showX&&this.showY&&this.showZ),o.visible=o.visible&&(o.name.indexOf("XY")===-1||this.showXY),o.visible=o.visible&&(o.name.indexOf("YZ")===-1||this.showYZ),o.visible=o.visible&&(o.name.indexOf("XZ")===-1||this.showXZ),o.visible=o.visible&&(o.name!=="E"||this.showE),o.visible=o.visible&&(o.name!=="XYZE"||this.showXYZE),o.material._color=o.material._color||o.material.color.clone(),o.material._opacity=o.material._opacity||o.material.opacity,o.material.color.copy(o.material._color),o.material.opacity=o.material._opacity,this.enabled&&this.axis&&(o.name===this.axis?(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1):this.axis.split("").some(function(l){return o.name===l})&&(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1))}super.updateMatrixWorld(e)}},Nd=class extends Me{constructor(){super(new Ls(1e5,1e5,2,2),new Rs({visible:!1,wireframe:!0,side:Ri,transparent:!0,opacity:.1,toneMapped:!1})),this.isTransformControlsPlane=!0,this.type="TransformControlsPlane"}updateMatrixWorld(e){let n=this.space;switch(this.position.copy(this.worldPosition),this.mode==="scale"&&(n="local"),Ku.copy(dl).applyQuaternion(n==="local"?this.worldQuaternion:Qu),hl.copy(Ur).applyQuaternion(n==="local"?this.worldQuaternion:Qu),fl.copy(pl).applyQuaternion(n==="local"?this.worldQuaternion:Qu),Bt.copy(hl),this.mode){case"translate":case"scale":switch(this.axis){case"X":Bt.copy(this.eye).cross(Ku),ps.copy(Ku).cross(Bt);break;case"Y":Bt.copy(this.eye).cross(hl),ps.copy(hl).cross(Bt);break;case"Z":Bt.copy(this.eye).cross(fl),ps.copy(fl).cross(Bt);break;case"XY":ps.copy(fl);break;case"YZ":ps.copy(Ku);break;case"XZ":Bt.copy(fl),ps.copy(hl);break;case"XYZ":case"E":ps.set(0,0,0);break}break;default:ps.set(0,0,0)}ps.length()===0?this.quaternion.copy(this.cameraQuaternion):(th.lookAt(dn.set(0,0,0),ps,Bt),this.quaternion.setFromRotationMatrix(th)),super.updateMatrixWorld(e)}};function q0(t,e,n,{crease:i=.7,normals:s=null}={}){let{area:r,unit:o}=mT(t,e),{first:a,corners:l}=pT(e,t.length/3),c={positions:new Float32Array(3*e.length),normals:new Float32Array(3*e.length),labels:new Float32Array(e.length)},u=new Uint32Array(e.length),h=Math.cos(i),f=0,d=[];for(let g=0;g+1<a.length;g++){let y=a[g],p=a[g+1]-y,m=f,v=s&&Math.hypot(s[3*g],s[3*g+1],s[3*g+2])>0;for(let T=y;T<y+p;T++){let S=Math.floor(l[T]/3),C=3*S,A=n[S],_=0,w=0,U=0,L=0,N=0;for(let I=0;I<p;I++){let z=3*Math.floor(l[y+I]/3),$=o[C]*o[z]+o[C+1]*o[z+1]+o[C+2]*o[z+2];z!==C&&!($>h)&&p<=31||(L|=1<<(I&31),N+=1,_+=r[z],w+=r[z+1],U+=r[z+2])}let k=m;for(;k<f&&!(d[k-m]===L&&c.labels[k]===A);)k++;if(u[l[T]]=k,k<f)continue;d[f-m]=L,c.labels[f]=A,v&&N===p&&(_=s[3*g],w=s[3*g+1],U=s[3*g+2]);let H=Math.hypot(_,w,U)||1;for(let I=0;I<3;I++)c.positions[3*f+I]=t[3*g+I];c.normals[3*f]=_/H,c.normals[3*f+1]=w/H,c.normals[3*f+2]=U/H,f+=1}}return{positions:c.positions.slice(0,3*f),normals:c.normals.slice(0,3*f),labels:c.labels.slice(0,f),index:u}}function pT(t,e){let n=new Uint32Array(e+1),i=new Uint32Array(t.length);for(let r of t)n[r+1]++;for(let r=0;r<e;r++)n[r+1]+=n[r];let s=n.slice();for(let r=0;r<t.length;r++)i[s[t[r]]++]=r;return{first:n,corners:i}}function mT(t,e){let n=new Float64Array(e.length),i=new Float64Array(e.length);for(let s=0;s<e.length;s+=3){let r=3*e[s],o=3*e[s+1],a=3*e[s+2],l=t[o]-t[r],c=t[o+1]-t[r+1],u=t[o+2]-t[r+2],h=t[a]-t[r],f=t[a+1]-t[r+1],d=t[a+2]-t[r+2];n[s]=c*d-u*f,n[s+1]=u*h-l*d,n[s+2]=l*f-c*h;let g=Math.hypot(n[s],n[s+1],n[s+2]);for(let y=s;y<s+3;y++)i[y]=g>0?n[y]/g:0}return{area:n,unit:i}}function $0(t){let e=new Float64Array(t.length),n=t.reduce((s,r)=>Math.max(s,r),0)+1;for(let s=0;s<t.length;s++){let r=t[s],o=t[s%3===2?s-2:s+1];e[s]=Math.min(r,o)*n+Math.max(r,o)}e.sort();let i=[];for(let s=0;s<e.length;s++)s>0&&e[s]===e[s-1]||i.push(Math.floor(e[s]/n),e[s]%n);return Uint32Array.from(i)}function Y0(t){let e=10**Math.floor(Math.log10(t));return e*[5,2,1].find(n=>n*e<=t*(1+1e-9))}function Dd(t){let e=[1/0,1/0,1/0],n=[-1/0,-1/0,-1/0];for(let s=0;s<t.length;s++){let r=s%3;t[s]<e[r]&&(e[r]=t[s]),t[s]>n[r]&&(n[r]=t[s])}let i=e.map((s,r)=>.5*(s+n[r]));return{min:e,max:n,center:i,radius:.5*Math.hypot(...e.map((s,r)=>n[r]-s))}}function Z0(t){let e=new un,n=new Me(t,new Vn({colorWrite:!1,transparent:!0,blending:Ds,vertexShader:"void main() { gl_Position = projectionMatrix * (modelViewMatrix * vec4(position, 1.0)); }",fragmentShader:"void main() { gl_FragColor = vec4(0.0); }"})),i=new Me(t,new Vn({transparent:!0,depthWrite:!1,uniforms:{tone:{value:new $e}},vertexShader:`varying float opacity;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  float rim = 1.0 - abs(dot(normalize(normalMatrix * normal), normalize(-seen.xyz)));
  opacity = 0.10 + 0.55 * rim * rim * rim;
  gl_Position = projectionMatrix * seen;
}`,fragmentShader:`varying float opacity; uniform vec3 tone;
void main() { gl_FragColor = vec4(tone, opacity); }`}));for(let s of[n,i])s.onBeforeRender=r=>r.getContext().depthRange(0,gT),s.onAfterRender=r=>r.getContext().depthRange(0,1);return n.renderOrder=10,i.renderOrder=11,e.add(n,i),e.visible=!1,{group:e,hidden:n,glass:i}}var gT=.01;function j0({glass:t},e){t.material.uniforms.tone.value.set(e).convertLinearToSRGB()}function J0(t,e){t.hidden.geometry=t.glass.geometry=e}function K0({object:t,ghost:e},n){let i=Math.hypot(...t.position.map((o,a)=>o-e.position[a])),s=new Tt(...t.quaternion),r=new Tt(...e.quaternion);return i/n+s.angleTo(r)}var Q0=t=>new $e(t).toArray(),Fr={from:[2.3,-1.5,3.6],colour:16774372,tone:Q0(16774372),strength:2.6},Or={from:[-2.2,2.2,1.2],colour:13624319,tone:Q0(13624319),strength:.9};function e_(t){let e=new Ba(16777215,9077624,1.5);e.position.set(0,0,1);let n=new To(Fr.colour,Fr.strength);n.position.set(...Fr.from),n.castShadow=!0,n.shadow.mapSize.setScalar(1536),Object.assign(n.shadow.camera,{left:-1.5,right:1.5,top:1.5,bottom:-1.5,near:.5,far:9}),n.shadow.radius=4,n.shadow.bias=-6e-4,n.shadow.normalBias=.006;let i=new To(Or.colour,Or.strength);i.position.set(...Or.from);let s=new Ga(16777215,.18);return t.add(e,n,i,s),{sky:e,key:n,rim:i,fill:s}}function t_(t){let e=new Me(new Ls(12,12),new Da({opacity:.2}));return e.receiveShadow=!0,e.renderOrder=-1,t.add(e),e}function nh(t,e,n,i){let{position:s,normal:r}=e.attributes,o=s.count,a=new jt;for(let u of["position","normal","color"])a.setAttribute(u,new en(new Float32Array(3*o*n),3).setUsage(Qa));let l=new Uint32Array(e.index.count*n);for(let u=0;u<l.length;u++)l[u]=e.index.array[u%e.index.count]+o*Math.floor(u/e.index.count);a.setIndex(new en(l,1)),a.boundingSphere=new Hi(new F,1/0);let c=i.map(([u,h])=>{u.vertexColors=!0;let f=new Me(a,u);return f.renderOrder=h,f.visible=!1,t.add(f),f});return{geometry:a,meshes:c,most:n,count:0,position:s.array,normal:r.array,perCopy:e.index.count}}function ih(t){t.count=0}function Bo(t,e,n,i,s){if(t.count===t.most)return;let{position:r,normal:o,geometry:{attributes:a}}=t,l=r.length*t.count;for(let c=0;c<r.length;c+=3)n_(a.position.array,l+c,r[c]*i.x,r[c+1]*i.y,r[c+2]*i.z,n,e),n_(a.normal.array,l+c,o[c]/i.x,o[c+1]/i.y,o[c+2]/i.z,n,_T),a.color.array[l+c]=s.r,a.color.array[l+c+1]=s.g,a.color.array[l+c+2]=s.b;t.count+=1}var _T=new F;function n_(t,e,n,i,s,r,o){let a=2*(r.y*s-r.z*i),l=2*(r.z*n-r.x*s),c=2*(r.x*i-r.y*n);t[e]=n+r.w*a+r.y*c-r.z*l+o.x,t[e+1]=i+r.w*l+r.z*a-r.x*c+o.y,t[e+2]=s+r.w*c+r.x*l-r.y*a+o.z}function sh({geometry:t,meshes:e,position:n,count:i,perCopy:s}){for(let r of e)r.visible=i>0;t.setDrawRange(0,s*i);for(let r of Object.values(t.attributes))r.clearUpdateRanges(),r.addUpdateRange(0,n.length*i),r.needsUpdate=i>0}var i_="thigma-theme";function rh(){let t=document.documentElement.dataset.theme;return t||(matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light")}function s_(t){let e=null;try{e=localStorage.getItem(i_)}catch{}return(e==="light"||e==="dark")&&(document.documentElement.dataset.theme=e),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>t()),function(){let i=rh()==="dark"?"light":"dark";document.documentElement.dataset.theme=i;try{localStorage.setItem(i_,i)}catch{}t()}}function St(t){return getComputedStyle(document.documentElement).getPropertyValue(`--${t}`).trim()}var Bs=["#0a8f83","#23ab6a","#7cc542","#bdd334","#e6d32e","#f5a32b","#ea7430","#d64a45"];function Br(t){return Bs[Math.max(0,Math.min(Bs.length-1,t))]}var ko=24,dr=1024;function o_(t){return{patchLevels:{value:t},spotCount:{value:0},spotRadius:{value:1},spots:{value:Array.from({length:ko},()=>new Ht)},levelColours:{value:Bs.map((e,n)=>new $e(Br(n)))},onlyActive:{value:0},patchTints:{value:null},tinted:{value:0}}}var a_=`attribute float patchNumber;
uniform sampler2D patchLevels;
uniform sampler2D patchTints;
uniform float tinted;
varying vec3 meshPoint;
flat varying vec2 patchState;
flat varying vec4 patchTint;`,l_=`meshPoint = position;
patchState = vec2(0.0);
patchTint = vec4(0.0);
if (patchNumber >= 0.0) {
  int patchIndex = int(patchNumber + 0.5);
  ivec2 cell = ivec2(patchIndex % ${dr}, patchIndex / ${dr});
  patchState = floor(texelFetch(patchLevels, cell, 0).rg * 255.0 + 0.5);
  if (tinted > 0.5) patchTint = vec4(texelFetch(patchTints, cell, 0).rgb, 1.0);
}`,c_=`varying vec3 meshPoint;
flat varying vec2 patchState;
flat varying vec4 patchTint;
uniform int spotCount;
uniform float spotRadius;
uniform float onlyActive;
uniform vec4 spots[${ko}];
uniform vec3 levelColours[${Bs.length}];
/// The colour of a point of the surface: its own, of its patch, or of a contact nearby.
vec3 markedColour(vec3 base) {
  int level = int(patchState.x) - 1;
  float share = level >= 0 ? 0.92 : 0.0;
  if (level < 0 && patchState.y > 0.5) {
    float nearest = 1.0;
    for (int k = 0; k < ${ko}; k++) {
      if (k >= spotCount) break;
      float d = distance(meshPoint, spots[k].xyz) / spotRadius;
      if (d < nearest) { nearest = d; level = int(spots[k].w); }
    }
    share = 0.85 * (1.0 - smoothstep(0.3, 1.0, nearest));
  }
  if (onlyActive > 0.5 && share < 0.02) discard;
  vec3 tone = levelColours[clamp(level, 0, ${Bs.length-1})];
  if (patchTint.a > 0.5) return mix(patchTint.rgb, tone, 0.75 * step(0.9, share));
  return mix(base, tone, share);
}`;function u_(t){let e=new Ua({roughness:.62,metalness:0});return e.onBeforeCompile=n=>{Object.assign(n.uniforms,t),n.vertexShader=n.vertexShader.replace("#include <common>",`#include <common>
${a_}`).replace("#include <begin_vertex>",`#include <begin_vertex>
${l_}`),n.fragmentShader=n.fragmentShader.replace("#include <common>",`#include <common>
${c_}`).replace("#include <color_fragment>",`#include <color_fragment>
diffuseColor.rgb = markedColour(diffuseColor.rgb);`)},e}var Ud=t=>`vec3(${t.map(e=>e.toFixed(5)).join(", ")})`,r_=({from:t})=>Ud(new F(...t).normalize().toArray()),Fd="gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);",Od="mat3(modelMatrix) * normal",Bd=`uniform vec3 base;
uniform float sky;
/// A colour as the screen takes it: roots in place of a power, which costs a processor more than all the rest (within a two
/// hundredth of it, from black to white).
vec3 screenColour(vec3 lit) {
  float peak = max(lit.r, max(lit.g, lit.b)), over = peak - 0.76; // bright ones flatten out, as by NeutralToneMapping
  if (over > 0.0) lit *= (1.0 - 0.0576 / (over + 0.24)) / peak;
  vec3 half_ = sqrt(lit), quarter = sqrt(half_), eighth = sqrt(quarter);
  return 0.662 * half_ + 0.6841 * quarter - 0.3236 * eighth - 0.0225 * lit;
}
/// facing   normal of the surface, any length [world]
vec3 litColour(vec3 colour, vec3 facing) {
  vec3 n = normalize(facing);
  vec3 light = mix(vec3(0.25, 0.22, 0.19), vec3(1.0), 0.5 + 0.5 * n.z) * sky + ${Fr.strength.toFixed(3)} * ${Ud(Fr.tone)} * max(0.0, dot(n, ${r_(Fr)}))
    + ${Or.strength.toFixed(3)} * ${Ud(Or.tone)} * max(0.0, dot(n, ${r_(Or)})) + 0.28;
  return screenColour(colour * light * 0.31831);
}`;function h_(t,e){return new Vn({uniforms:{base:t,sky:e},vertexShader:`${Bd}
varying vec3 lit;
invariant gl_Position;
void main() {
  lit = litColour(base, ${Od});
  ${Fd}
}`,fragmentShader:`varying vec3 lit;
void main() {
  gl_FragColor = vec4(lit, 1.0);
}`})}function f_(t,e,n){return new Vn({uniforms:{...t,base:e,sky:n},vertexShader:`${a_}
varying vec3 facing;
invariant gl_Position;
void main() {
  ${l_}
  facing = ${Od};
  ${Fd}
}`,fragmentShader:`${c_}
${Bd}
varying vec3 facing;
void main() {
  gl_FragColor = vec4(litColour(markedColour(base), facing), 1.0);
}`})}function kd(t,{opacity:e=1,...n}={}){let i=new $e(1,1,1),s=new Vn({...n,uniforms:{base:{value:i},sky:t??{value:0},opacity:{value:e}},vertexShader:`${Bd}
varying vec3 lit;
void main() {
  vec3 tone = base;
#ifdef USE_COLOR
  tone *= color;
#endif
  ${Fd}
${t?`  vec3 facing = ${Od};
#ifdef DOUBLE_SIDED
  vec3 seen = (modelViewMatrix * vec4(position, 1.0)).xyz;
  if (dot(mat3(viewMatrix) * facing, seen) > 0.0) facing = -facing;
#endif
  lit = litColour(tone, facing);`:"  lit = screenColour(tone);"}
}`,fragmentShader:`varying vec3 lit; uniform float opacity;
void main() { gl_FragColor = vec4(lit, opacity); }`});return Object.assign(s,{color:i})}var zd=512,p_=16,vl=new F(0,0,1);function zo(t,e={}){return t?kd(t,e):new Fa(e)}function Go(t,e={}){let n={transparent:!0,opacity:.42,depthTest:!1,depthWrite:!1,...e};return t?kd(null,n):new Rs(n)}var Rn=(t,e,n)=>t?n:e;function m_(t){let e=new un,n=new Wt(.5,.5,1,Rn(t,20,8)).rotateX(Math.PI/2).translate(0,0,.5),i=new Is(1.35,3.6,Rn(t,28,12)).rotateX(Math.PI/2).translate(0,0,1.8),s=[];for(let r of[zo(t),Go(t)]){let o=new Me(n,r),a=new Me(i,r);o.renderOrder=a.renderOrder=r.depthTest?0:20,s.push({shaft:o,head:a,material:r}),e.add(o,a)}return e.visible=!1,{group:e,parts:s}}function g_(t,e,n,i){let s=n.length();if(t.group.visible=s>.2*i,!t.group.visible)return;t.group.position.copy(e),t.group.quaternion.setFromUnitVectors(vl,n.clone().divideScalar(s));let r=Math.min(i,s/3.6);for(let{shaft:o,head:a}of t.parts)o.scale.set(r,r,Math.max(1e-6*i,s-3.4*r)),a.scale.setScalar(r),a.position.set(0,0,s-3.6*r)}function __(t,e){for(let{material:n}of t.parts)n.color.set(e)}var d_=.055;function x_(t){let e=new un,n={steps:Rn(t,72,36),sides:Rn(t,10,5)},i=xT(n),s=new Is(.15,.38,Rn(t,24,10)),r=[];for(let o of[zo(t),Go(t)]){let a=new Me(i,o),l=new Me(s,o);a.renderOrder=l.renderOrder=o.depthTest?0:20,r.push({ring:a,head:l,material:o}),e.add(a,l)}return e.visible=!1,{group:e,parts:r,ring:i,arc:n}}function xT({steps:t,sides:e}){let n=[],i=[],s=[];for(let o=0;o<=t;o++){let a=2*Math.PI*o/t;for(let l=0;l<e;l++){let c=2*Math.PI*l/e,u=Math.cos(c),h=Math.sin(c);i.push(u*Math.cos(a),u*Math.sin(a),h);let f=1+d_*u;n.push(f*Math.cos(a),f*Math.sin(a),d_*h);let d=(l+1)%e;if(o<t){let g=o*e+l,y=o*e+d;s.push(g,y,g+e,y,y+e,g+e)}}}let r=new jt;return r.setAttribute("position",new en(Float32Array.from(n),3)),r.setAttribute("normal",new en(Float32Array.from(i),3)),r.setIndex(s),r}function v_(t,e,n,i,s){if(t.group.visible=i>.01&&n.lengthSq()>0,!t.group.visible)return;t.group.position.copy(e),t.group.quaternion.setFromUnitVectors(vl,n.clone().normalize()),t.group.scale.setScalar(s);let r=Math.max(1,Math.round(300/360*t.arc.steps*Math.min(1,i)));t.ring.setDrawRange(0,r*t.arc.sides*6);let o=2*Math.PI*r/t.arc.steps;for(let{head:a}of t.parts)a.position.set(Math.cos(o),Math.sin(o),0),a.rotation.set(0,0,o),a.scale.setScalar(Math.min(1,.25+4*i))}function y_(t,e){for(let{material:n}of t.parts)n.color.set(e)}function S_(t){let e=new un,n=new us(1,Rn(t,8,5),Rn(t,6,3)),i=new Wt(.22,.22,1,Rn(t,5,3),1,!!t).rotateX(Math.PI/2).translate(0,0,.5),s=new Xi(1,.12,Rn(t,5,3),Rn(t,28,16)),r=(o,a,l,c)=>nh(e,o,a,[[zo(t),1],[Go(t,{opacity:l}),c]]);return{group:e,dots:r(n,zd,.45,21),needles:r(i,zd,.45,21),rings:r(s,p_,.55,22)}}var ml=new Tt,gl=new F,_l=new F,xl=new $e;function Gd(t,e,n,i,s){let{dots:r,needles:o,rings:a}=t;for(let l of[r,o,a])ih(l);for(let{point:l,normal:c,level:u}of e.slice(0,zd))gl.set(...l),ml.setFromUnitVectors(vl,_l.set(...c).normalize()),xl.set(Br(u)),Bo(r,gl,ml,_l.set(i,i,i),xl),Bo(o,gl,ml,_l.set(i,i,5.5*i),xl);xl.set(s);for(let{point:l,normal:c,share:u}of n.slice(0,p_)){gl.set(...l),ml.setFromUnitVectors(vl,_l.set(...c).normalize());let h=i*(2.6+2.4*Math.sqrt(Math.max(0,Math.min(1,u))));Bo(a,gl,ml,_l.set(h,h,h),xl)}for(let l of[r,o,a])sh(l)}function M_(t){let e=zo(t),n=Go(t,{opacity:.5}),i=new un,s=new Wt(1,1,1,Rn(t,10,6)).rotateX(Math.PI/2).translate(0,0,.5),r=new us(1,Rn(t,16,8),Rn(t,12,6)),o=[],a=[];for(let l of[e,n]){let c=new Me(s,l),u=new Me(r,l);c.renderOrder=u.renderOrder=l.depthTest?0:23,o.push(c),a.push(u),i.add(c,u)}return{group:i,rods:o,knobs:a,materials:[e,n]}}function b_(t,e,n,i){let s=n.clone().sub(e),r=s.length();t.group.position.copy(e),r>0&&t.group.quaternion.setFromUnitVectors(vl,s.divideScalar(r));for(let o of t.rods)o.scale.set(i,i,Math.max(r,1e-9*i));for(let o of t.knobs)o.position.set(0,0,r),o.scale.setScalar(2.6*i)}function w_(t,e){for(let n of t.materials)n.color.set(e)}var Hd=64,Vd=new F(0,0,1);function A_(t){let e=new un,n={planes:t?new Na(1,10):new Wt(1,1,.06,20).rotateX(Math.PI/2),points:new us(.36,Rn(t,8,5),Rn(t,6,3)),forces:new Wt(.16,.16,1,Rn(t,6,4),1,!!t).rotateX(Math.PI/2).translate(0,0,.5),heads:new Is(.42,1,Rn(t,12,6)).rotateX(Math.PI/2).translate(0,0,.5),cones:new Is(1,1,Rn(t,20,10),1,!0).translate(0,-.5,0).rotateX(-Math.PI/2)},i={group:e};for(let[s,r]of Object.entries(n)){let o=s==="cones"||s==="planes",a=zo(t,o?{transparent:!0,opacity:s==="cones"?.34:.72,depthWrite:!1,side:2}:{}),l=Go(t,{opacity:o?.16:.5,side:o?2:0});i[s]=nh(e,r,s==="points"?2*Hd:Hd,[[a,o?3:2],[l,22]])}return i}var oh=new Tt,yl=new F,ah=new F,vT=new F,E_=new $e;function Wd(t,e,{size:n,longest:i},s){let r=e.slice(0,Hd),o=Math.max(1e-30,...r.map(({force:u})=>Math.hypot(...u))),{group:a,...l}=t;for(let u of Object.values(l))ih(u);let c=(u,h,f)=>Bo(t[u],yl,oh,vT.set(h,h,f),E_);for(let{point:u,normal:h,gap:f,force:d,friction:g,kind:y,presses:p}of r){E_.set(p?s.press:s.near);let m=u.map((A,_)=>A+f*h[_]),v=p?n:.62*n;if(oh.setFromUnitVectors(Vd,ah.set(...h).normalize()),yl.set(...y===1?m:u),c("points",v,v),yl.set(...y===1?u:m),c(y===2?"points":"planes",v,v),!p)continue;yl.set(...u),g>0&&(oh.setFromUnitVectors(Vd,ah.set(...h).multiplyScalar(-1).normalize()),c("cones",.8*i*g,.8*i));let T=Math.hypot(...d);if(!(T>0))continue;oh.setFromUnitVectors(Vd,ah.set(...d).divideScalar(T));let S=i*(.25+.75*T/o),C=Math.min(1.1*n,.5*S);c("forces",n,S-C),yl.addScaledVector(ah,S-C),c("heads",n,C)}for(let u of Object.values(l))sh(u)}function T_(t,e,n){let i=0;return(t??[]).forEach(({free:s,triangles:r,deviation:o},a)=>{a>0&&!s&&r>0&&Number.isFinite(o)&&o!==null&&o<=n*e&&r<t[i].triangles&&(i=a)}),i}function C_(t,e){for(let n=t;n>0;n--)if(e(n))return n;return 0}function R_(t,e){for(let n=t.length;n>0;n--)if(t[n-1].deviation<=e)return-n;return 0}function P_(t,e,n){let i=new Float64Array(3*n).fill(1/0),s=new Float64Array(3*n).fill(-1/0);for(let o=0;o<e.length;o++)for(let a=0;e[o]>=0&&a<3;a++){let l=3*e[o]+a,c=t[3*o+a];c<i[l]&&(i[l]=c),c>s[l]&&(s[l]=c)}let r=new Float32Array(4*n).fill(-1);for(let o=0;o<n;o++){if(!(i[3*o]<=s[3*o]))continue;let a=0;for(let l=0;l<3;l++)r[4*o+l]=.5*(i[3*o+l]+s[3*o+l]),a+=(s[3*o+l]-i[3*o+l])**2;r[4*o+3]=.5*Math.sqrt(a)}return r}function I_(t,e,n,i){i.fill(0);for(let{point:[s,r,o]}of e)for(let a=0;a<i.length;a++){let l=t[4*a+3]+n;if(t[4*a+3]<0)continue;let c=t[4*a]-s,u=t[4*a+1]-r,h=t[4*a+2]-o;c*c+u*u+h*h<l*l&&(i[a]=255)}}function L_(t,e){let n=e.length,i=new Uint32Array(n);for(let f of t)i[f]++;let s=ST(e),r=i.slice();for(let f=n-1;f>=0;f--){let d=s[f];e[d]>=0&&(r[e[d]]+=r[d])}let o=new Uint32Array(n),a=new Uint32Array(n),l=new Uint32Array(n),c=0;for(let f of s){let d=e[f];o[f]=d<0?c:l[d],a[f]=o[f]+r[f],d<0?c=a[f]:l[d]=a[f],l[f]=o[f]+i[f]}let u=new Uint32Array(t.length),h=o.slice();for(let f=0;f<t.length;f++)u[h[t[f]]++]=f;return{order:u,begin:o,end:a}}function ST(t){let e=t.map(()=>0);for(let r of t)r>=0&&e[r]++;let n=new Uint32Array(t.length),i=t.length,s=[];for(let r=0;r<t.length;r++)e[r]===0&&s.push(r);for(;s.length>0;){let r=s.pop();n[--i]=r,t[r]>=0&&--e[t[r]]===0&&s.push(t[r])}if(i!==0)throw new RangeError("the hierarchy runs in a circle");return n}function N_(t,e,n){n.fill(0);for(let{node:i,level:s}of e)if(!(i<0||i>=t.begin.length))for(let r=t.begin[i];r<t.end[i];r++){let o=t.order[r];(n[o]===0||n[o]>s+1)&&(n[o]=Math.min(255,s+1))}}var MT=(t,e)=>t.patchOfTriangle[e]===4294967295?-1:t.patchOfTriangle[e];function D_(t){let e=new Float32Array(t.triangles.length/3);for(let n=0;n<e.length;n++)e[n]=MT(t,n);return e}function U_(t,e){let n=new Uint32Array(e+1);for(let r of t)r>=0&&(n[r+1]+=1);for(let r=0;r<e;r++)n[r+1]+=n[r];let i=new Uint32Array(n[e]),s=n.slice();return t.forEach((r,o)=>{r>=0&&(i[s[r]++]=o)}),{begin:n,list:i}}function F_(t,e,n,i){return Int32Array.from(t,s=>{let r=s;for(;e[r]>=0&&n[e[r]]<=i;)r=e[r];return r})}function O_(t,e,n,i){i.fill(0);let s=n.filter(({node:r})=>r>=0&&r<t.begin.length);for(let r=0;r<e.length;r++){let o=e[r];if(!(o<0||o>=t.begin.length))for(let{node:a,level:l}of s)t.begin[a]<=t.begin[o]&&t.end[o]<=t.end[a]&&(i[r]===0||i[r]>l+1)&&(i[r]=Math.min(255,l+1))}}function B_(t){let e=t*.61803398875%1,n=[.62,.5,.72][t%3],i=.55,s=r=>{let o=(r+e*12)%12;return Math.round(255*(n-i*Math.min(n,1-n)*Math.max(-1,Math.min(o-3,9-o,1))))};return[s(0),s(8),s(4)]}var Xd=new WeakMap;function bT(t){let e=t.nodeOfPatch.length,n=D_(t),i=q0(t.positions,t.triangles,n,{normals:t.normals}),s=new jt;return s.setAttribute("position",new en(i.positions,3)),s.setAttribute("normal",new en(i.normals,3)),s.setAttribute("patchNumber",new en(i.labels,1)),s.setIndex(new en(i.index,1)),{geometry:s,byPatch:U_(n,e),balls:P_(i.positions,i.labels,e)}}function Sl(t,e=L_(t.nodeOfPatch,t.parents)){Xd.has(t)||Xd.set(t,bT(t));let{geometry:n,byPatch:i,balls:s}=Xd.get(t),r=t.nodeOfPatch.length,o=new Uint8Array(2*dr*k_(t)),a=z_(o,Zi),l=o_(a),c={value:new $e},u={value:1},h={rich:u_(l),plain:f_(l,c,u),bare:h_(c,u)};h.rich.color=c.value;let f=new Me(n,h.rich);f.castShadow=f.receiveShadow=!0;let d=new Ra(new jt,new ir({transparent:!0,opacity:.16}));d.visible=!1;let g=wT(n,h.plain),y=new un;return y.add(f,g,d),{group:y,solid:f,stain:g,lines:d,rich:!0,byPatch:i,uniforms:l,geometry:n,mesh:t,ranges:e,materials:h,colour:c,sky:u,state:o,patchLevels:a,bytes:new Uint8Array(r),near:new Uint8Array(r),balls:s}}function wT(t,e){let n=new jt;for(let[s,r]of Object.entries(t.attributes))n.setAttribute(s,r);n.setIndex(new en(new Uint32Array(t.index.count),1).setUsage(Qa)),n.boundingSphere=new Hi(new F,1/0);let i=new Me(n,e);return i.renderOrder=.5,i.visible=!1,i}function ET({stain:t,geometry:e,byPatch:{begin:n,list:i},bytes:s,near:r}){let o=e.index.array,{index:a}=t.geometry,l=0;for(let c=0;c<s.length;c++)if(!(!s[c]&&!r[c]))for(let u=n[c];u<n[c+1];u++,l+=3)for(let h=0;h<3;h++)a.array[l+h]=o[3*i[u]+h];a.clearUpdateRanges(),a.addUpdateRange(0,l),a.needsUpdate=!0,t.geometry.setDrawRange(0,l)}function lh(t){let{solid:e,stain:n,materials:i,uniforms:s,rich:r}=t,o=s.onlyActive.value===0&&s.tinted.value===0;e.material=r?i.rich:o?i.bare:i.plain,n.visible=e.visible&&!r&&o&&n.geometry.drawRange.count>0}var k_=t=>Math.max(1,Math.ceil(t.nodeOfPatch.length/dr)),AT=new Map([[Xa,1],[Zi,2],[ci,4]]);function z_(t,e){let n=new Eo(t,dr,t.length/(dr*AT.get(e)),e,$n);return n.unpackAlignment=1,n.needsUpdate=!0,n}function G_(t,e){let{uniforms:n,mesh:i}=t;if(n.tinted.value=e===null?0:1,lh(t),e===null||t.tintedAt===e)return;let s=i.parents?F_(i.nodeOfPatch,i.parents,i.levels,e):i.nodeOfPatch,r=new Uint8Array(4*dr*k_(i));s.forEach((o,a)=>r.set([...B_(Math.max(0,o)),255],4*a)),n.patchTints.value?.dispose(),n.patchTints.value=z_(r,ci),t.tintedAt=e}function ch(t,{base:e,line:n,sky:i}){t.colour.value.set(e),t.sky.value=i,t.lines.material.color.set(n)}function uh(t,e){t.rich=e,lh(t)}function V_(t,e,n){t.solid.visible=e!=="none",t.uniforms.onlyActive.value=e==="active"?1:0,lh(t),t.lines.visible=n>0,t.lines.material.opacity=n,n>0&&!t.lines.geometry.index&&(t.lines.geometry.setAttribute("position",new en(t.mesh.positions,3)),t.lines.geometry.setIndex(new en($0(t.mesh.triangles),1)))}function H_(t,e,n,i,s){let{bytes:r,near:o,balls:a,state:l,uniforms:c}=t;t.mesh.parents?N_(t.ranges,e,r):O_(t.ranges,t.mesh.nodeOfPatch,e,r);let u=n.slice(0,ko);I_(a,u,i,o);for(let h=0;h<r.length;h++)a[4*h+3]>s&&(r[h]=0),l[2*h]=r[h],l[2*h+1]=o[h];t.patchLevels.needsUpdate=!0,c.spotCount.value=u.length,c.spotRadius.value=i,u.forEach(({point:h,level:f},d)=>c.spots.value[d].set(...h,f)),ET(t),lh(t)}function W_(t,e,n=ko){let i=[];for(let s of t){if(i.length===n)break;i.some(o=>o.level===s.level&&TT(o.point,s.point)<e)||i.push(s)}return i}var TT=(t,e)=>Math.hypot(t[0]-e[0],t[1]-e[1],t[2]-e[2]);function X_(t){t.geometry.dispose(),t.stain.geometry.dispose(),t.patchLevels.dispose(),t.uniforms.patchTints.value?.dispose(),t.lines.geometry.dispose();for(let e of Object.values(t.materials))e.dispose();t.lines.material.dispose()}function qd(t,e){let n=Sl(t);return{group:n.group,geometry:n.geometry,finest:n,about:e,levels:new Map,coarse:null,relief:null,browsed:null,wireframe:!1,drawn:0,rich:!0,colours:null}}function $_(t,e){return e>0&&!t.levels.has(e)&&$d(t,e)}function $d({about:t},e){let n=t.level_list?.[e];return!!n&&!n.free&&n.triangles>0}function Y_(t,e){t.levels.has(e.level)||Z_(t,e.level,Sl(e,t.finest.ranges))}function Z_(t,e,n){t.levels.set(e,n),t.group.add(n.group),t.colours&&ch(n,t.colours),uh(n,t.rich),fh(t)}function j_(t,e){let{nodeOfPatch:n,parents:i,levels:s}=t.finest.mesh;t.relief||e.patches!==n.length||(t.relief=Sl({...e,nodeOfPatch:n,parents:i,levels:s},t.finest.ranges),t.group.add(t.relief.group),t.colours&&ch(t.relief,t.colours),uh(t.relief,t.rich),fh(t))}function Ml(t,e){t.colours=e;for(let n of bl(t))ch(n,e)}function Yd(t,e){t.rich=e;for(let n of bl(t))uh(n,e)}var bl=t=>[t.finest,...t.levels.values(),...t.relief?[t.relief]:[]],J_=(t,e)=>t.levels.get(e)??t.finest;function hh(t,{wireframe:e=t.wireframe,browsed:n=t.browsed}){Object.assign(t,{wireframe:e,browsed:n}),fh(t)}var CT=4e3,q_=Array.from({length:10},(t,e)=>6e-4*1.5**e);function K_(t,e){let{radius:n,triangles:i}=t.about;return t.coarse||i<CT||e<q_[0]*n?null:(t.coarse=[],q_.map(s=>s*n))}function Q_(t,e,n){t.coarse.push({mesh:{...t.finest.mesh,...e},deviation:n,triangles:e.triangles.length/3})}function Zd(t,e,n){let{level_list:i,triangles:s}=t.about,r=T_(i,e,n),o=R_(t.coarse??[],n*e);return o===0||(i?.[r]?.triangles??s)<=t.coarse[-1-o].triangles?r:(t.levels.has(o)||Z_(t,o,Sl(t.coarse[-1-o].mesh,t.finest.ranges)),o)}function ex(t,e){let n=e<0?e:C_(e,i=>t.levels.has(i));return n===t.drawn?!1:(t.drawn=n,fh(t),!0)}var jd=(t,e=t.drawn)=>J_(t,e),tx=t=>t.drawn===0&&t.relief?t.relief:jd(t),RT=(t,e)=>e!==t.relief&&![...t.levels].some(([n,i])=>n<0&&i===e);function fh(t){let{browsed:e,wireframe:n}=t,i=e===null?n?null:tx(t):J_(t,e);for(let s of bl(t)){let r=e!==null&&s===i;G_(s,r?e:null);let o=s===i?"whole":i===null&&RT(t,s)?"active":"none";V_(s,o,r?.3:n&&e===null&&s===t.finest?.16:0)}}function Jd(t,e,n){let i=.03*n,s=.075*n,r=a=>t.levels.get(a),o=t.browsed===null&&!t.wireframe;for(let a of bl(t)){let l=({level:u})=>o?a===tx(t):a===t.finest?!r(u)||t.browsed!==null:a===r(u),c=e.filter(l);H_(a,c,W_(c,i),s,o?2*s:1/0)}}function nx(t){for(let e of bl(t))X_(e)}var kr=[{pixels:2,shadows:!0,rich:!0,off:0,before:1/0},{pixels:1,shadows:!0,rich:!0,off:0,before:4},{pixels:1,shadows:!1,rich:!0,off:.5,before:4},{pixels:1,shadows:!1,rich:!1,off:.5,before:7},{pixels:1,shadows:!1,rich:!1,off:1,before:1.7},{pixels:1,shadows:!1,rich:!1,off:2,before:1.7}],rx=3,PT=1/20,Kd=.045,IT=(t,e)=>e*kr[t].before<Kd,ix=2,LT=3,ox=60;function ax({step:t=0,fixed:e=!1}={}){return{first:t,step:t,fixed:e,seen:0,mean:0,patience:ox,climbed:!1}}function lx(t,e){if(t.seen+=1,t.fixed||t.seen<=ix)return!1;let n=t.seen-ix;return t.mean+=(e-t.mean)/Math.min(n,8),n>=LT&&t.mean>Kd&&t.step<kr.length-1?(t.climbed&&(t.patience*=4),sx(t,1),!0):n>=t.patience&&IT(t.step,t.mean)?(sx(t,-1),!0):!1}function cx(t){let e=Math.max(t.first,kr.findIndex(({off:n})=>n>0));!t.fixed&&e<t.step&&Object.assign(t,{step:e,seen:0,mean:0,patience:ox,climbed:!1})}function sx(t,e){Object.assign(t,{step:t.step+e,seen:0,mean:0,climbed:e<0})}function ux(t,e){return!e&&t<Kd?0:Math.max(.25*t,Math.min(t,PT-t-.01))}function hx(t,e){if(!t.world)return null;let n=[];for(let i of e)n[i.about.body]=i;return{byNumber:n,held:[],shown:null}}function fx(t,e,n){e.bodies.forEach(({position:s,quaternion:r},o)=>{let a=t.byNumber[o]?.group;a?.position.fromArray(s),a?.quaternion.fromArray(r)});let i=e.hands.map(({body:s})=>s).filter(s=>t.byNumber[s]);t.shown=t.byNumber[NT(e)?.body]??t.shown,i.join()!==t.held.join()&&(t.held=i,Qd(t,n))}function NT({hands:t}){let e=({body:n})=>n>=0;return t.find(n=>n.page&&e(n))??t.find(e)??null}var DT=.14,UT=(t,e)=>new $e(t).offsetHSL(0,0,DT*(.618*e%1-.5));function Qd(t,e){t.byNumber.forEach((n,i)=>{let s=t.held.includes(i)?"held":n.about.moves?"moving":"fixed";Ml(n,{base:s==="moving"?UT(St(s),i):St(s),line:St(`${s}-line`),sky:e})})}function dh({canvas:t,view:e,world:n},i){let s=t.getBoundingClientRect(),r=i?new it((i.clientX-s.left)/s.width*2-1,1-(i.clientY-s.top)/s.height*2):new it,o=new Ns;o.setFromCamera(r,e.camera);let[a]=o.intersectObjects(n.byNumber.map(c=>c.finest.solid),!1),l=a&&n.byNumber.find(c=>c.finest.solid===a.object);return l?.about.moves?{name:l.about.name,point:l.group.worldToLocal(a.point.clone()).toArray()}:null}var ep=1.6;function FT(){let t=document.createElement("canvas").getContext("webgl2"),e=t?.getExtension("WEBGL_debug_renderer_info"),n=e?t.getParameter(e.UNMASKED_RENDERER_WEBGL):"";return t?.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(n)}function dx(t,e=null){let n=e==="plain"||e!=="full"&&FT(),i=new Bu({canvas:t,antialias:!n,alpha:!0,powerPreference:"high-performance"});i.outputColorSpace=ni,i.toneMapping=Ha,i.debug.checkShaderErrors=!n,i.shadowMap.enabled=!0,i.shadowMap.type=Er,i.shadowMap.autoUpdate=!1;let s=new Aa,r=new un;s.add(r);let o=n?{value:1}:null,a={canvas:t,renderer:i,scene:s,root:r,view:g0(),plain:n,lights:e_(s),ground:t_(s),radius:1,size:1,object:null,statics:[],world:null,ghost:null,force:m_(o),twist:x_(o),marks:S_(o),rows:A_(o),spring:M_(o),markLight:o,dirty:!0,options:{wireframe:!1,ghost:!0,contacts:!0,forces:!0,names:!0},editing:!1,start:null,wants:()=>{},done:()=>{},wanted:new Set,last:null,moved:!0,resized:!0,fence:null,begun:0,rested:0,isSeen:!1,coarsener:null,pace:ax({step:n?rx:0,fixed:e==="full"})};return r.add(a.force.group,a.twist.group,a.marks.group,a.rows.group,a.spring.group),a.spring.group.visible=!1,a}function px(t,e,n,i=!1){let s=i?t.last:null;for(let r of Pn(t))t.root.remove(r.group),nx(r);t.ghost&&t.root.remove(t.ghost.group),t.coarsener?.terminate(),t.coarsener=t.last=null,t.isSeen=!1,t.start={position:e.start.position,quaternion:e.start.quat_xyzw},mx(t),t.object=qd(n.get(e.object.mesh),e.object),t.statics=e.statics.map(r=>{let o=qd(n.get(r.mesh),r);return wl(o.group,{position:r.position,quaternion:r.quat_xyzw}),o}),t.world=hx(e,Pn(t));for(let r of Pn(t))hh(r,{wireframe:t.options.wireframe}),Yd(r,kr[t.pace.step].rich);t.ghost=Z0(t.object.geometry),wl(t.object.group,t.start),t.root.add(t.object.group,...t.statics.map(r=>r.group),t.ghost.group),t.size=e.object.radius,t.wanted.clear(),i||VT(t),t.moved=!0,mh(t),s&&El(t,s)}function mx(t){for(let{group:e}of[t.force,t.twist,t.spring])e.visible=!1;Gd(t.marks,[],[],1,St("ring")),Wd(t.rows,[],{size:1,longest:1},{near:St("contact"),press:St("press")})}function gx(t,e){if(t.editing!==e&&(t.editing=e,!!t.object)){if(!e&&t.last){El(t,t.last);return}mx(t),t.ghost.group.visible=!1;for(let n of Pn(t))Jd(n,[],t.size);wl(t.object.group,t.start),t.dirty=t.moved=!0}}var Pn=t=>t.object?[t.object,...t.statics]:[];function _x(t,e){for(let n of Pn(t))n.about.mesh===e.number&&Y_(n,e);t.last&&Al(t,t.last),t.dirty=t.moved=!0}function xx(t,e){for(let n of Pn(t))n.about.mesh===e.number&&j_(n,e);t.last&&Al(t,t.last),t.dirty=t.moved=!0}function vx(t,e,n){hh(e,{browsed:n}),n!==null&&ph(t,e,n),t.last&&Al(t,t.last),t.dirty=t.moved=!0}var OT=3,BT=1e3;async function ph(t,e,n){let i=`${e.about.mesh} ${n}`,{wanted:s}=t;if(!$_(e,n)||s.has(i))return;s.add(i),(await t.wants(e.about.mesh,n)).ok||setTimeout(()=>s.delete(i),BT)}function kT(t,e,n){if(!t.isSeen)return;let i=K_(e,n);if(!i)return;t.coarsener??=Object.assign(new Worker("coarsener.js"),{onmessage:({data:a})=>zT(t,a)});let{positions:s,triangles:r,patchOfTriangle:o}=e.finest.mesh;t.coarsener.postMessage({body:Pn(t).indexOf(e),mesh:{positions:s,triangles:r,patchOfTriangle:o},tolerances:i})}function zT(t,{body:e,surface:n,deviation:i}){Q_(Pn(t)[e],n,i),cx(t.pace),t.resized=t.dirty=!0}function GT(t){let{off:e}=kr[t.pace.step],n=new F,i=!1;for(let s of Pn(t)){let{center:r,radius:o,relief:a}=s.about;t.root.localToWorld(n.set(...r).applyQuaternion(s.group.quaternion).add(s.group.position));let l=Math.max(t.view.camera.near,ol(t.view,n)-o/t.radius),c=rl(t.view,l,t.canvas.clientHeight)*t.radius,u=e-(a??0)/c;kT(t,s,u*c);let h=Zd(s,c,u);if(ph(t,s,h),i=ex(s,h)||i,s!==(t.world?.shown??t.object))continue;let f=Zd(s,c,OT*e);ph(t,s,f),J0(t.ghost,jd(s,f).geometry)}i&&t.last&&Al(t,t.last)}function wl(t,e){t.position.fromArray(e.position),t.quaternion.fromArray(e.quaternion)}function VT(t){let e=[];for(let{group:i,geometry:s}of[t.object,...t.statics]){let r=Dd(s.attributes.position.array);i.updateMatrix();for(let o=0;o<8;o++){let a=[0,1,2].map(l=>o&1<<l?r.max[l]:r.min[l]);e.push(...new F(...a).applyMatrix4(i.matrix).toArray())}}let n=Dd(e);t.radius=n.radius>0?n.radius:1,t.root.scale.setScalar(1/t.radius),t.root.position.fromArray(n.center).multiplyScalar(-1/t.radius),t.ground.position.z=(n.min[2]-n.center[2])/t.radius-.012,t.root.updateMatrixWorld()}function mh(t){let e=Number(St("sky"));if(t.object){Ml(t.object,{base:St("held"),line:St("held-line"),sky:e});for(let n of t.statics)Ml(n,{base:St("fixed"),line:St("fixed-line"),sky:e});t.world&&Qd(t.world,e),j0(t.ghost,St("ghost"))}__(t.force,St("force")),y_(t.twist,St("torque")),w_(t.spring,St("hand")),t.ground.material.opacity=Number(St("shadow")),t.lights.sky.intensity=e,t.markLight&&(t.markLight.value=e),t.dirty=!0}function El(t,e,n=null){if(!t.object||(t.last=e,t.editing))return;t.world?n&&fx(t.world,n,Number(St("sky"))):wl(t.object.group,e.object),wl(t.ghost.group,e.ghost);let i=(e.bits&1)!==0,s=new F(...e.grasp),r=new F(...e.handle.position);t.ghost.group.visible=t.options.ghost&&i&&K0(e,t.size)>.004,t.spring.group.visible=t.options.ghost&&i,b_(t.spring,s,r,.012*t.size),HT(t,e,s),Al(t,e),t.dirty=t.moved=!0}function HT(t,e,n){if(!t.options.forces){t.force.group.visible=t.twist.group.visible=!1;return}let i=e.metresPerNewton>0?e.metresPerNewton:.5*t.size,s=new F(...e.force).multiplyScalar(ep*i);s.clampLength(0,4*t.size),g_(t.force,n,s,.045*t.size);let r=new F(...e.torque),o=.5*t.size*t.size/i;v_(t.twist,n,r,r.length()/o,.42*t.size)}function Al(t,e){if(t.editing)return;let n=(e.bits&Lr.constrained)!==0,i=t.options.contacts&&!n?e.contacts:[];if(Wd(t.rows,t.options.contacts?e.rows:[],{size:.045*t.size,longest:.34*t.size},{near:St("contact"),press:St("press")}),t.world)return;let s=Math.max(1e-30,...e.clusters.map(a=>Math.hypot(...a.force)));Gd(t.marks,i.map(a=>({point:a.point,normal:a.normal,level:a.objectLevel})),t.options.contacts?e.clusters.map(a=>({point:a.point,normal:a.normal,share:Math.hypot(...a.force)/s})):[],.011*t.size,St("ring"));let r=(a,l)=>{if(Jd(a,l.map(({point:c,node:u,level:h})=>({point:WT(a.group,c),node:u,level:h})),t.size),a.wireframe)for(let{level:c}of l)ph(t,a,c)},o=n&&t.object.about.levels<=1?[]:e.contacts;r(t.object,o.map(a=>({point:a.point,node:a.objectNode,level:a.objectLevel}))),t.statics.forEach((a,l)=>r(a,o.filter(c=>c.body===l).map(c=>({point:c.point,node:c.sceneNode,level:c.sceneLevel}))))}function WT(t,e){return new F(...e).sub(t.position).applyQuaternion(t.quaternion.clone().conjugate()).toArray()}function yx(t,e){Object.assign(t.options,e);for(let n of Pn(t))hh(n,{wireframe:t.options.wireframe});t.last&&El(t,t.last),t.dirty=!0}function Tl(t){let{clientWidth:e,clientHeight:n}=t.canvas;e===0||n===0||t.renderer.xr.isPresenting||(t.resized=!0,t.view.camera.aspect=e/n,t.view.camera.fov=e<n?38:30,t.view.camera.updateProjectionMatrix(),ji(t.view))}function XT(t){let{clientWidth:e,clientHeight:n}=t.canvas,{pixels:i,shadows:s,rich:r}=kr[t.pace.step];t.renderer.setPixelRatio(t.plain?1:Math.min(i,devicePixelRatio)),e>0&&n>0&&t.renderer.setSize(e,n,!1),t.lights.key.castShadow=t.ground.visible=s;for(let o of Pn(t))Yd(o,r);t.resized=!1,t.moved=!0}var Sx=t=>Mx(t)&&performance.now()>=t.rested;function Mx(t){if(!t.fence)return!0;let e=t.renderer.getContext(),n=performance.now();if(!e.isContextLost()){if(e.getSyncParameter(t.fence,e.SYNC_STATUS)!==e.SIGNALED)return!1;e.deleteSync(t.fence);let i=.001*(n-t.begun);t.rested=n+1e3*ux(i,t.plain),t.resized||=lx(t.pace,i),t.dirty||=!t.isSeen,t.isSeen=!0}return t.fence=null,!0}function bx(t){Mx(t)?t.done(t.rested-performance.now()):setTimeout(bx,wx,t)}var wx=4;function Ex(t){if(!(t.dirty||t.view.changed))return!1;let e=t.renderer.getContext();return t.resized&&XT(t),GT(t),t.dirty=t.view.changed=!1,t.renderer.shadowMap.needsUpdate=t.moved,t.moved=!1,t.begun=performance.now(),t.renderer.render(t.scene,t.view.camera),t.fence=e.fenceSync(e.SYNC_GPU_COMMANDS_COMPLETE,0),e.flush(),setTimeout(bx,wx,t),!0}function Ax(t,e){let n=t.root.localToWorld(new F(...e));return 2*Math.tan(t.view.camera.fov*Math.PI/360)*ol(t.view,n)*t.radius/Math.max(1,t.canvas.clientHeight)}function Tx(t,e){let n=new eh(t.view.camera,t.canvas),i={stage:t,controls:n,index:null,isDragging:!1};return n.setSize(.9),n.addEventListener("change",()=>{t.dirty=!0}),n.addEventListener("dragging-changed",({value:s})=>{i.isDragging=s;let r=Pn(t)[i.index];!s&&r&&e({position:r.group.position.toArray(),quaternion:r.group.quaternion.toArray()})}),i}function tp(t,e,n){let{stage:i,controls:s}=t,r=e===null?null:Pn(i)[e];t.index=r?e:null;let o=s.getHelper();r?(s.setMode(n),s.attach(r.group),i.scene.add(o)):(s.detach(),i.scene.remove(o)),i.dirty=!0}function Cx(t,e){if(t.index===null||e.button!==0)return!1;let n=t.stage.canvas.getBoundingClientRect();return t.controls.pointerHover({x:(e.clientX-n.left)/n.width*2-1,y:1-(e.clientY-n.top)/n.height*2,button:e.button}),t.controls.axis!==null}function Rx(t,e){let n={url:t,on:e,worker:new Worker("worker.js"),isOpen:!1,attempt:0,nextId:1,asked:new Map,received:0,bytes:0,posted:0,gone:0,stopped:!1};return n.worker.onmessage=({data:i})=>qT(n,i),n.worker.onerror=()=>Dx(n,"The page could not start its worker. Reload the page."),n.worker.postMessage({open:t,origin:performance.timeOrigin}),n}function qT(t,e){if(!t.stopped)if(e.data!==void 0)try{$T(t,e.data)}finally{t.worker.postMessage({taken:1})}else e.opened?(Object.assign(t,{isOpen:!0,attempt:0}),t.on.opened()):e.lost?Ux(t,e.lost):e.gone!==void 0&&(t.gone=e.gone)}function $T(t,e){if(!t.isOpen)return;t.received+=1,t.bytes+=typeof e=="string"?e.length:e.byteLength;let n=null;try{n=typeof e=="string"?F0(e):U0(e)}catch(i){if(!(i instanceof cl))throw i;Dx(t,`The program says something this page does not understand: ${i.message}. Reload the page.`);return}n.type==="ack"&&YT(t,n),t.on.message(n)}function YT(t,e){let n=t.asked.get(e.id);t.asked.delete(e.id),n?.(e)}function ks(t,e){if(!t.isOpen)return Promise.resolve({ok:!1,reason:"The program is not connected."});let n=t.nextId;return t.nextId=n===2147483647?1:n+1,t.worker.postMessage({text:JSON.stringify({...e,id:n})}),new Promise(i=>t.asked.set(n,i))}function Px(t,e){t.isOpen&&e.length>0&&t.worker.postMessage({hand:e})}var Ix=t=>t?.worker.postMessage({letGo:!0});function Lx(t,e){return t.isOpen?(t.posted+=e.byteLength,t.worker.postMessage({bytes:e},[e]),!0):!1}var Nx=t=>Math.max(0,t.posted-t.gone);function Dx(t,e){t.stopped=!0,t.worker.postMessage({stop:!0}),Ux(t,e)}function Ux(t,e){Object.assign(t,{isOpen:!1,posted:0,gone:0,attempt:t.attempt+1});for(let n of t.asked.values())n({ok:!1,reason:"The connection was lost."});t.asked.clear(),t.on.lost(e)}var ZT=.06,jT=1.5;function gh(t,e,n){let i=Math.max(ZT,Math.min(jT,e)),s=vi(qu([0,0,1],t+Math.PI/2),qu([1,0,0],Math.PI/2));return{azimuth:t,radius:n,shown:i,turn:s,metres:n/i}}function Fx(){return{source:null,last:null,isHeld:!1,down:new Set}}function Ox(t,e,n,i,s){let r=new Set(t.down);for(let{source:a,grabs:l}of e)l?t.down.add(a):t.down.delete(a);if(t.source===null){let a=e.find(({source:l,grabs:c,pose:u})=>c&&u&&!r.has(l));return a?(Object.assign(t,{source:a.source,last:a.pose,isHeld:!1}),"press"):null}let o=e.find(({source:a})=>a===t.source);return!o?.grabs||!o.pose||t.isHeld&&!i.clutch?(_h(t),"letGo"):(t.isHeld||=i.clutch,o.free||JT(t.last,o.pose,n,i,s),t.last=o.pose,null)}function _h(t){Object.assign(t,{source:null,last:null,isHeld:!1})}function JT(t,e,n,i,s){let r=ul(n.turn,e.position.map((a,l)=>a-t.position[l]));$u(i,r.map(a=>a*n.metres),s);let o=vi(e.quaternion,Nr(t.quaternion));Td(i,vi(vi(n.turn,o),Nr(n.turn)),s)}var Bx=[["immersive-vr","Enter VR"],["immersive-ar","Enter AR"]],KT=[0,-.3,-.55],QT=.22,eC=.2,np=60;async function zx(t=navigator.xr){if(!t)return[];let e=await Promise.all(Bx.map(([n])=>t.isSessionSupported(n).catch(()=>!1)));return Bx.filter((n,i)=>e[i])}function Gx(t){return{world:t,session:null,mode:null,busy:!1,rig:new un,room:null,hand:Fx(),grabbing:new Set,freeing:new Set,last:0,pulsed:0,frames:0}}var Vx=t=>!!t?.session&&t.hand.source!==null;async function Hx(t,e){if(!t.busy){if(t.session){await t.session.end();return}t.busy=!0;try{await tC(t,e)}finally{t.busy=!1}t.world.changed()}}async function tC(t,e){let{stage:n}=t.world,{renderer:i}=n,s=await navigator.xr.requestSession(e,{optionalFeatures:["hand-tracking"]});s.addEventListener("visibilitychange",()=>{s.visibilityState!=="visible"&&Wx(t)});for(let[o,a]of[["select",t.grabbing],["squeeze",t.freeing]])s.addEventListener(`${o}start`,({inputSource:l})=>a.add(l)),s.addEventListener(`${o}end`,({inputSource:l})=>a.delete(l));Object.assign(t,{session:s,mode:e,last:0,frames:0}),ip(t,gh(n.view.azimuth,QT,n.radius)),n.scene.add(t.rig),t.rig.add(n.view.camera),i.xr.enabled=!0,i.xr.setReferenceSpaceType("local"),e==="immersive-vr"&&i.setClearColor(St("stage"),1);let r=i.xr.setSession(s);s.addEventListener("end",()=>kx(t,s));try{await r}catch(o){throw await s.end().catch(()=>{}),kx(t,s),o}t.session===s&&i.xr.setAnimationLoop((o,a)=>iC(t,o,a))}function ip(t,e){let{rig:n,world:{stage:i}}=t;t.room=e,n.quaternion.fromArray(e.turn),n.scale.setScalar(1/e.shown),n.position.fromArray(KT).applyQuaternion(n.quaternion).multiplyScalar(-1/e.shown).add(i.view.target),n.updateMatrixWorld()}function kx(t,e){if(t.session!==e)return;let{stage:n,leave:i,changed:s}=t.world,{renderer:r}=n;t.session=t.mode=null,Wx(t),i();for(let o of[t.grabbing,t.freeing,t.hand.down])o.clear();r.xr.setAnimationLoop(null),r.setAnimationLoop(null),r.xr.enabled=!1,r.setClearColor(0,0),t.rig.remove(n.view.camera),n.scene.remove(t.rig),n.view.camera.scale.setScalar(1),Tl(n),ji(n.view),s()}function Wx(t){t.hand.source!==null&&(_h(t.hand),t.world.player.letGo())}function nC(t,e,n){let i=t.getPose(e.gripSpace,n);if(!i||i.emulatedPosition)return null;let{position:s,orientation:r}=i.transform;return{position:[s.x,s.y,s.z],quaternion:[r.x,r.y,r.z,r.w]}}function iC(t,e,n){let{world:i,session:s}=t;if(!s)return;t.room.radius!==i.stage.radius&&ip(t,gh(t.room.azimuth,t.room.shown,i.stage.radius));let r=Math.min(.1,(e-t.last)/1e3);t.last=e,t.frames+=1;let o=i.stage.renderer.xr.getReferenceSpace(),a=[...s.inputSources].filter(({gripSpace:c})=>c).map(c=>({source:c,grabs:t.grabbing.has(c),free:t.freeing.has(c),pose:nC(n,c,o)}));if(sC(t,a),t.hand.source===null)for(let{source:c}of a)rC(t,c,r);else oC(t,e);i.moment();let{stage:l}=i;l.renderer.shadowMap.needsUpdate=l.moved,l.moved=l.dirty=!1,l.renderer.render(l.scene,l.view.camera)}function sC(t,e){let{player:n,take:i}=t.world,s=Ox(t.hand,e,t.room,n.hand,n.workspace());s==="letGo"?n.letGo():s==="press"&&!n.mayMove()?(_h(t.hand),i()):s==="press"&&n.press(),t.hand.source!==null&&(hr(n.hand,performance.now()/1e3),n.moved(!0),n.give())}function rC(t,{gamepad:e},n){let[,,i=0,s=0]=e?.axes??[];if(Math.hypot(i,s)<eC)return;let{azimuth:r,shown:o}=t.room;ip(t,gh(r+1.5*n*i,o*Math.exp(-1.2*n*s),t.world.stage.radius))}function oC(t,e){let{gamepad:n}=t.hand.source,i=t.world.strength();if(!n||i<.02||e-t.pulsed<np)return;t.pulsed=e;let[s]=n.hapticActuators??[];s?.pulse?s.pulse(i,np+20)?.catch?.(()=>{}):n.vibrationActuator?.playEffect?.("dual-rumble",{duration:np+20,strongMagnitude:i,weakMagnitude:.5*i}).catch(()=>{})}function Xx(t){let{session:e,hand:n}=t,i={page:t,player:null,wanted:!1,next:null,last:null};return i.player={get stage(){return t.stage},hand:n,workspace:()=>e.scene.workspace,grasp:()=>e.snapshot?.grasp??[0,0,0],claims:s=>t.gizmo!==null&&Cx(t.gizmo,s),mayMove:()=>e.connected&&!t.stage?.editing&&e.hello?.may_control!==!1&&!!e.state?.device.startsWith("web:")&&e.state.holder!=="other"&&e.state.run!=="ended"&&!e.state.replay&&!!e.snapshot,press:(s=null)=>qx(i,s),moved:s=>{e.turned||=s},give:()=>Yx(i),letGo:()=>{i.wanted=!1,i.next=null,n.clutch=!1,Cl(i)}},i}async function qx(t,e,n=Cd(t.page.hand)){let{session:i,hand:s,request:r,stage:o}=t.page;if(s.clutch&&i.holding)return;if(i.asking){t.wanted||(t.next={pick:e,from:n}),t.wanted=!0;return}i.asking=t.wanted=!0,i.holding||xh(t,(await r({type:"hold",value:!0})).ok);let a=i.holding&&(!i.scene.world||await aC(t,e??dh(o,null)??t.last));i.asking=!1;let{next:l}=t;if(t.next=null,l){await qx(t,l.pick,l.from);return}!i.holding||!a||!t.wanted||(hr(s,performance.now()/1e3,n),s.clutch=!0,Cl(t))}async function aC(t,e){return e?(t.last=e,(await t.page.request({type:"grab",value:e.name,point:e.point})).ok):!1}function $x(t,{object:e,statics:n},i){let s=[e,...n].filter(({moves:o})=>o);return(s.find(({name:o})=>o===i?.name)??(t==="add"?s[0]:null))?.name??null}function xh({page:{session:t,link:e}},n){t.holding&&!n&&Ix(e),t.holding=n}function Yx({page:{session:t,hand:e,link:n}}){if(!t.holding||!t.connected)return;let i=Zu(e);Px(n,i),t.sent+=i.length}function Cl(t){let{session:e,hand:n,xr:i}=t.page;!e.holding||Vx(i)||(hr(n,performance.now()/1e3),Yx(t))}function Zx(t){let{session:e,link:n}=t.page;e.holding&&(t.player.letGo(),xh(t,!1),ks(n,{type:"hold",value:!1}))}var jx=.008;function Jx(t){let{canvas:e}=t.stage,n={player:t,pointers:new Map,mode:null,keys:new Set,hasPad:!1,given:-1/0,touch:matchMedia("(pointer: coarse)").matches};e.addEventListener("contextmenu",i=>i.preventDefault()),e.addEventListener("pointerdown",i=>lC(n,i)),e.addEventListener("pointermove",i=>Kx(n,i)),e.addEventListener("pointerrawupdate",i=>uC(n,i));for(let i of["pointerup","pointercancel"])e.addEventListener(i,s=>dC(n,s));return e.addEventListener("wheel",i=>pC(n,i),{passive:!1}),addEventListener("keydown",i=>gC(n,i)),addEventListener("keyup",({key:i})=>n.keys.delete(i)),addEventListener("blur",()=>n.keys.clear()),addEventListener("gamepadconnected",()=>{n.hasPad=!0}),e.addEventListener("dblclick",i=>{i.button===2&&Gu(t.stage.view)}),n}function lC(t,e){let{canvas:n}=t.player.stage;if(n.focus({preventScroll:!0}),t.player.claims(e))return;n.setPointerCapture(e.pointerId),t.pointers.set(e.pointerId,{x:e.clientX,y:e.clientY,stamp:e.timeStamp}),t.touch=e.pointerType==="touch";let{stage:i}=t.player,s=i.world&&e.button===0?dh(i,e):null,r=i.world?s!==null:!t.touch||cC(t,e);t.touch?t.pointers.size===1&&(t.mode=r&&t.player.mayMove()?"hand":"view"):e.button===0?t.mode=r&&t.player.mayMove()?"hand":"view":t.mode=e.button===1||e.shiftKey?"pan":"view",t.mode==="hand"&&t.player.press(s),n.classList.toggle("grabbing",t.mode==="hand")}function cC({player:{stage:t}},e){if(!t.object)return!1;let n=t.canvas.getBoundingClientRect(),i=new it((e.clientX-n.left)/n.width*2-1,1-(e.clientY-n.top)/n.height*2),s=new Ns;return s.setFromCamera(i,t.view.camera),s.intersectObject(t.object.finest.solid,!1).length>0}function uC(t,e){t.mode!=="hand"||t.pointers.size!==1||e.timeStamp-t.given>=1e3*Ad&&Kx(t,e)}function Kx(t,e){let n=t.pointers.get(e.pointerId);if(n){if(t.pointers.size===2)fC(t,e,n);else{let i=e.getCoalescedEvents?.()??[];for(let s of i.length>0?i:[e])s.timeStamp<=n.stamp||(n.stamp=s.timeStamp,hC(t,s,s.clientX-n.x,s.clientY-n.y),n.x=s.clientX,n.y=s.clientY)}n.x=e.clientX,n.y=e.clientY,t.mode==="hand"&&(t.given=e.timeStamp,t.player.give())}}function hC(t,e,n,i){let{stage:s}=t.player;if(!(n===0&&i===0)){if(t.mode==="view")return dd(s.view,n,i);if(t.mode==="pan")return pd(s.view,n,i,s.canvas.clientHeight);if(t.mode==="hand")return e.ctrlKey||e.altKey||e.metaKey?vh(t,n,i,0,e.timeStamp):e.shiftKey?Vo(t,0,0,-i,e.timeStamp):Vo(t,n,i,0,e.timeStamp)}}function Vo(t,e,n,i,s){let{stage:r,hand:o}=t.player,a=Ax(r,t.player.grasp()),{right:l,up:c,forward:u}=cr(r.view),h=[0,1,2].map(f=>a*(e*l.getComponent(f)-n*c.getComponent(f)+i*u.getComponent(f)));$u(o,h,t.player.workspace()),hr(o,s/1e3),t.player.moved(!1)}function vh(t,e,n,i,s){let{stage:r,hand:o}=t.player,{right:a,up:l,forward:c}=cr(r.view),u=t.player.workspace();Yu(o,l.toArray(),jx*e,u),Yu(o,a.toArray(),jx*n,u),i!==0&&Yu(o,c.toArray(),i,u),hr(o,s/1e3),t.player.moved(!0)}function fC(t,e,n){let[i]=[...t.pointers].filter(([h])=>h!==e.pointerId).map(([,h])=>h),s={x:n.x-i.x,y:n.y-i.y},r={x:e.clientX-i.x,y:e.clientY-i.y},o=(Math.hypot(r.x,r.y)||1)/(Math.hypot(s.x,s.y)||1),a=Math.atan2(s.x*r.y-s.y*r.x,s.x*r.x+s.y*r.y),l=.5*(e.clientX-n.x),c=.5*(e.clientY-n.y),{stage:u}=t.player;t.mode==="hand"?(vh(t,l,c,a,e.timeStamp),Vo(t,0,0,-200*Math.log(o),e.timeStamp)):(pd(u.view,l,c,u.canvas.clientHeight),Uo(u.view,1/o))}function dC(t,e){t.pointers.delete(e.pointerId),!(t.pointers.size>0)&&(t.mode==="hand"&&t.player.stage.world&&t.player.letGo(),t.mode=null,t.player.stage.canvas.classList.remove("grabbing"))}function pC(t,e){e.preventDefault();let n=e.deltaY*(e.deltaMode===1?16:e.deltaMode===2?400:1);t.mode==="hand"?(Vo(t,0,0,-.4*n,e.timeStamp),t.player.give()):Uo(t.player.stage.view,Math.exp(.0012*n))}var Qx={ArrowLeft:[-1,0,0],ArrowRight:[1,0,0],ArrowUp:[0,-1,0],ArrowDown:[0,1,0],PageUp:[0,0,1],PageDown:[0,0,-1]},mC=160;function gC(t,e){let n=e.target===t.player.stage.canvas||e.target===document.body;!Qx[e.key]||!n||(e.preventDefault(),Object.assign(t,{turns:e.ctrlKey||e.altKey||e.metaKey,views:e.shiftKey}),t.keys.add(e.key))}function ev(t,e){if(t.keys.size===0)return;let{hand:n,stage:i}=t.player,s=mC*Math.min(.1,e),[r,o,a]=[0,1,2].map(l=>s*[...t.keys].reduce((c,u)=>c+Qx[u][l],0));!n.clutch||t.views?(dd(i.view,r,o),a!==0&&Uo(i.view,Math.exp(-.004*a))):t.turns?vh(t,r,o,.01*a,performance.now()):Vo(t,r,o,a,performance.now()),t.player.give()}var _C=.12;function tv(t,e,n,i){if(!t.hasPad)return!1;let s=[...navigator.getGamepads?.()??[]].find(a=>a?.connected);if(!s)return!1;let{player:r}=t,o=a=>Math.abs(s.axes[a]??0)>_C?s.axes[a]:0;if(s.buttons[0]?.pressed&&r.mayMove()&&r.press(),s.buttons[1]?.pressed&&r.letGo(),r.hand.clutch){let a=220*Math.min(.1,e),l=(s.buttons[7]?.value??0)-(s.buttons[6]?.value??0);(o(0)||o(1)||l)&&Vo(t,a*o(0),a*o(1),a*l,performance.now()),(o(2)||o(3))&&vh(t,a*o(2),a*o(3),0,performance.now())}return xC(t,s,Math.min(1,n/i)),!0}function xC(t,e,n){let i=performance.now();!e.vibrationActuator?.playEffect||n<.02||i-(t.rumbled??-1e9)<60||(t.rumbled=i,e.vibrationActuator.playEffect("dual-rumble",{duration:80,strongMagnitude:n,weakMagnitude:.5*n}).catch(()=>{}))}function le(t,e="",n=""){return Object.assign(document.createElement(t),{className:e,textContent:n})}function zn(t,e,n=""){let i=Object.assign(le("button",n,t),{type:"button"});return i.addEventListener("click",e),i}function vC({min:t,max:e,scale:n},i){let s=n==="log"?Math.log(i/t)/Math.log(e/t):(i-t)/(e-t);return Math.max(0,Math.min(1,s))}function nv({min:t,max:e,scale:n},i){return n==="log"?t*(e/t)**i:t+i*(e-t)}var Rl=t=>String(Number(t.toPrecision(3)));function iv(t,e){return{parent:t,ask:e,rows:new Map}}function sv(t,e){let n=new Set(e.map(i=>i.name));for(let[i,s]of t.rows)n.has(i)||(s.box.remove(),t.rows.delete(i));for(let i of e)t.rows.has(i.name)||t.rows.set(i.name,SC(t,i)),MC(t.rows.get(i.name),i)}function yC(t,e){let n=le("div","parameter"),i=le("div","parameter-top"),s=le("span","words"),r=le("label","",e.label),o=le("p","note"),a=le("p","refusal"),l=le("p","warning");a.setAttribute("role","alert"),s.setAttribute("role","radiogroup"),s.setAttribute("aria-label",e.label);let c=e.choices.map((h,f)=>{let d=Object.assign(le("button","chip-button",h),{type:"button"});return d.setAttribute("role","radio"),d.addEventListener("click",()=>{u.parameter.value!==f&&Pl(t,u,f)}),s.append(d),d});i.append(r,s),n.append(i,o,a,l),t.parent.append(n);let u={box:n,buttons:c,help:o,refusal:a,warning:l,parameter:e,busy:!1,next:null};return u}function SC(t,e){if(e.kind==="choice")return yC(t,e);let n=le("div","parameter"),i=le("label","",e.label),s=Object.assign(le("input"),{type:"range",min:0,max:1,step:.001,id:`parameter-${e.name}`});i.htmlFor=s.id;let r=Object.assign(le("input","value"),{type:"text",inputMode:"decimal"});r.setAttribute("aria-label",`${e.label}, ${e.unit}`);let o=le("span","unit",e.unit),a=le("p","note"),l=le("p","refusal");l.setAttribute("role","alert");let c=le("div","parameter-top"),u=le("p","warning"),h={box:n,slider:s,number:r,help:a,refusal:l,warning:u,parameter:e,busy:!1,next:null,on:null};return e.kind==="optional"&&(h.on=Object.assign(le("input","switch"),{type:"checkbox"}),h.on.setAttribute("aria-label",`${e.label} on`),h.kept=e.value||nv(e,.5),h.on.addEventListener("change",()=>Pl(t,h,h.on.checked?Number(Rl(h.kept)):0)),c.append(h.on)),c.append(i,r,o),n.append(c,s,a,l,u),t.parent.append(n),s.addEventListener("input",()=>{let f=Number(Rl(nv(h.parameter,Number(s.value))));r.value=Rl(f),Pl(t,h,f)}),r.addEventListener("change",()=>{let f=Number(r.value.replace(",","."));r.value.trim()!==""&&Number.isFinite(f)?Pl(t,h,f):rv(h,`"${r.value}" is not a number.`)}),h}async function Pl(t,e,n){if(e.busy){e.next=n;return}e.busy=!0;let i=await t.ask(e.parameter.name,n);if(e.busy=!1,e.next!==null){let s=e.next;e.next=null,Pl(t,e,s);return}if(!i.ok){rv(e,i.reason??"Refused.");return}e.refusal.textContent="",e.parameter={...e.parameter,value:i.value??n},sp(e),e.box.classList.remove("changed"),e.box.offsetWidth,e.box.classList.add("changed")}function rv(t,e){let{value:n,unit:i,choices:s}=t.parameter,r=s?.length>0?s[n]:t.on&&n===0?"off":`${Rl(n)} ${i}`.trim();t.refusal.textContent=`${e.replace(/[.]?$/,".")} It stays at ${r}.`,sp(t)}function MC(t,e){t.parameter=e;let n=e.begins_again?" Begins again.":"";t.help.textContent=e.locked??`${e.help??""}${n}`,t.warning.textContent=e.warning?`Risky: ${e.warning}.`:"";let i=!!e.locked;t.box.classList.toggle("locked",i);for(let s of[t.slider,t.number,t.on,...t.buttons??[]])s&&(s.disabled=i);!t.busy&&document.activeElement!==t.number&&sp(t)}function sp(t){let{value:e}=t.parameter;if(t.buttons?.forEach((i,s)=>i.setAttribute("aria-checked",String(s===e))),t.buttons)return;let n=t.on!==null&&e===0;t.on&&(t.on.checked=!n,n||(t.kept=e),t.box.classList.toggle("off",n)),t.slider.value=vC(t.parameter,n?t.kept:e),t.number.value=n?"off":Rl(e)}var bC=200;function ov(t,e){let n=le("div",`event ${e.kind}`);for(n.append(le("time","",`${Pi(e.time)} s`),le("span","",Wu(e))),t.prepend(n);t.childElementCount>bC;)t.lastChild.remove()}var wC=[["Drag","moves the hand in the plane of the screen"],["Wheel while dragging, or Shift + drag","moves it away from you and back"],["Ctrl or Alt + drag","turns it"],["Space","lets go, or takes hold"],["Arrow keys, Page up and down","move the hand that holds, on the picture; with Ctrl or Alt they turn it, with Shift the view"],["Right drag, wheel","turns and zooms the view; middle drag shifts it"],["Touch","one finger on the object moves it, a second turns and lifts it; beside it fingers move the view"],["Gamepad","sticks move and turn, triggers push and pull, A holds, B lets go; it rumbles with the force"],["VR or AR","where a headset is there: the trigger holds, squeezing frees the controller, its stick turns and sizes the scene"],["Scene tab","put a scene together: drop meshes, drag the handles, Ctrl+Z takes a step back"],["P . R O","pause, one step, begin again, open a scene"],["F L G C A N","fit the view; levels of detail, ghost, contacts, arrows, names on and off"],["S","sound of contact on and off: changes of the force"],["1 to 6, + -","look along the axes, as the buttons of the compass do; nearer and farther"]];function av(t){let e=le("h2","","The mouse is the hand"),n=le("p","lead","Drag the blue object: the ghost shows where your hand is, the object where it may be, and the line between them, as long as the force is strong, is what a haptic device would let you feel."),i=le("dl");for(let[o,a]of wC){let l=/^(Drag|Touch|Gamepad)$/.test(o)?"":"for-mouse";i.append(le("dt",l,o),le("dd",l,a))}let s=le("p","note");s.append(Ho("force","force on the hand"),Ho("torque","torque, turning along the arc"),Ho("ring","clusters of contacts"),Ho("levels","dots: contacts with their normals, in the colour of their level of detail"),Ho("contact","under constraints, discs: planes that the object keeps off, with the points they keep off"),Ho("press","those that press, with their force and the cone it may lie in"));let r=Object.assign(le("button","primary","Close"),{type:"button"});r.addEventListener("click",()=>t.close()),t.addEventListener("click",o=>{o.target===t&&t.close()}),t.replaceChildren(e,n,i,s,r)}function Ho(t,e){let n=le("span",`key ${t}`,e);return n.prepend(le("i")),n}var EC="uplot",AC="u-hz",TC="u-vt",CC="u-title",RC="u-wrap",PC="u-under",IC="u-over",LC="u-axis",Vr="u-off",NC="u-select",DC="u-cursor-x",UC="u-cursor-y",FC="u-cursor-pt",OC="u-legend",BC="u-live",kC="u-inline",zC="u-series",GC="u-marker",lv="u-label",VC="u-value",Ll="width",Nl="height";var cv="bottom",Wo="left",rp="right",Mp="#000",uv=Mp+"0",op="mousemove",hv="mousedown",ap="mouseup",fv="mouseenter",dv="mouseleave",pv="dblclick",HC="resize",WC="scroll",mv="change",wh="dppxchange",bp="--",Jo=typeof window<"u",fp=Jo?document:null,qo=Jo?window:null,XC=Jo?navigator:null,Ct,yh;function dp(){let t=devicePixelRatio;Ct!=t&&(Ct=t,yh&&mp(mv,yh,dp),yh=matchMedia(`(min-resolution: ${Ct-.001}dppx) and (max-resolution: ${Ct+.001}dppx)`),Hr(mv,yh,dp),qo.dispatchEvent(new CustomEvent(wh)))}function yi(t,e){if(e!=null){let n=t.classList;!n.contains(e)&&n.add(e)}}function pp(t,e){let n=t.classList;n.contains(e)&&n.remove(e)}function Jt(t,e,n){t.style[e]=n+"px"}function Ji(t,e,n,i){let s=fp.createElement(t);return e!=null&&yi(s,e),n?.insertBefore(s,i),s}function Ii(t,e){return Ji("div",t,e)}var gv=new WeakMap;function ms(t,e,n,i,s){let r="translate("+e+"px,"+n+"px)",o=gv.get(t);r!=o&&(t.style.transform=r,gv.set(t,r),e<0||n<0||e>i||n>s?yi(t,Vr):pp(t,Vr))}var _v=new WeakMap;function xv(t,e,n){let i=e+n,s=_v.get(t);i!=s&&(_v.set(t,i),t.style.background=e,t.style.borderColor=n)}var vv=new WeakMap;function yv(t,e,n,i){let s=e+""+n,r=vv.get(t);s!=r&&(vv.set(t,s),t.style.height=n+"px",t.style.width=e+"px",t.style.marginLeft=i?-e/2+"px":0,t.style.marginTop=i?-n/2+"px":0)}var wp={passive:!0},qC={...wp,capture:!0};function Hr(t,e,n,i){e.addEventListener(t,n,i?qC:wp)}function mp(t,e,n,i){e.removeEventListener(t,n,wp)}Jo&&dp();function Ki(t,e,n,i){let s;n=n||0,i=i||e.length-1;let r=i<=2147483647;for(;i-n>1;)s=r?n+i>>1:Si((n+i)/2),e[s]<t?n=s:i=s;return t-e[n]<=e[i]-t?n:i}function Yv(t){return(n,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(t(n[a])){r=a;break}for(let a=s;a>=i;a--)if(t(n[a])){o=a;break}return[r,o]}}var Zv=t=>t!=null,jv=t=>t!=null&&t>0,Th=Yv(Zv),$C=Yv(jv);function YC(t,e,n,i=0,s=!1){let r=s?$C:Th,o=s?jv:Zv;[e,n]=r(t,e,n);let a=t[e],l=t[e];if(e>-1)if(i==1)a=t[e],l=t[n];else if(i==-1)a=t[n],l=t[e];else for(let c=e;c<=n;c++){let u=t[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??kt,l??-kt]}function Ch(t,e,n,i){let s=bv(t),r=bv(e);t==e&&(s==-1?(t*=n,e/=n):(t/=n,e*=n));let o=n==10?zs:Jv,a=s==1?Si:Li,l=r==1?Li:Si,c=a(o(Ln(t))),u=l(o(Ln(e))),h=$o(n,c),f=$o(n,u);return n==10&&(c<0&&(h=zt(h,-c)),u<0&&(f=zt(f,-u))),i||n==2?(t=h*s,e=f*r):(t=ty(t,h),e=Rh(e,f)),[t,e]}function Ep(t,e,n,i){let s=Ch(t,e,n,i);return t==0&&(s[0]=0),e==0&&(s[1]=0),s}var Ap=.1,Sv={mode:3,pad:Ap},Ul={pad:0,soft:null,mode:0},ZC={min:Ul,max:Ul};function Eh(t,e,n,i){return Ph(n)?Mv(t,e,n):(Ul.pad=n,Ul.soft=i?0:null,Ul.mode=i?3:0,Mv(t,e,ZC))}function Et(t,e){return t??e}function jC(t,e,n){for(e=Et(e,0),n=Et(n,t.length-1);e<=n;){if(t[e]!=null)return!0;e++}return!1}function Mv(t,e,n){let i=n.min,s=n.max,r=Et(i.pad,0),o=Et(s.pad,0),a=Et(i.hard,-kt),l=Et(s.hard,kt),c=Et(i.soft,kt),u=Et(s.soft,-kt),h=Et(i.mode,0),f=Et(s.mode,0),d=e-t,g=zs(d),y=ai(Ln(t),Ln(e)),p=zs(y),m=Ln(p-g);(d<1e-24||m>10)&&(d=0,(t==0||e==0)&&(d=1e-24,h==2&&c!=kt&&(r=0),f==2&&u!=-kt&&(o=0)));let v=d||y||1e3,T=zs(v),S=$o(10,Si(T)),C=v*(d==0?t==0?.1:1:r),A=zt(ty(t-C,S/10),24),_=t>=c&&(h==1||h==3&&A<=c||h==2&&A>=c)?c:kt,w=ai(a,A<_&&t>=_?_:Qi(_,A)),U=v*(d==0?e==0?.1:1:o),L=zt(Rh(e+U,S/10),24),N=e<=u&&(f==1||f==3&&L>=u||f==2&&L<=u)?u:-kt,k=Qi(l,L>N&&e<=N?N:ai(N,L));return w==k&&w==0&&(k=100),[w,k]}var JC=new Intl.NumberFormat(Jo?XC.language:"en-US"),Tp=t=>JC.format(t),Mi=Math,bh=Mi.PI,Ln=Mi.abs,Si=Mi.floor,In=Mi.round,Li=Mi.ceil,Qi=Mi.min,ai=Mi.max,$o=Mi.pow,bv=Mi.sign,zs=Mi.log10,Jv=Mi.log2,KC=(t,e=1)=>Mi.sinh(t)*e,lp=(t,e=1)=>Mi.asinh(t/e),kt=1/0;function wv(t){return(zs((t^t>>31)-(t>>31))|0)+1}function gp(t,e,n){return Qi(ai(t,e),n)}function Kv(t){return typeof t=="function"}function vt(t){return Kv(t)?t:()=>t}var QC=()=>{},Qv=t=>t,ey=(t,e)=>e,eR=t=>null,Ev=t=>!0,Av=(t,e)=>t==e,tR=/\.\d*?(?=9{6,}|0{6,})/gm,Wr=t=>{if(iy(t)||mr.has(t))return t;let e=`${t}`,n=e.match(tR);if(n==null)return t;let i=n[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Wr(s)}e${r}`}return zt(t,i)};function zr(t,e){return Wr(zt(Wr(t/e))*e)}function Rh(t,e){return Wr(Li(Wr(t/e))*e)}function ty(t,e){return Wr(Si(Wr(t/e))*e)}function zt(t,e=0){if(iy(t))return t;let n=10**e,i=t*n*(1+Number.EPSILON);return In(i)/n}var mr=new Map;function ny(t){return((""+t).split(".")[1]||"").length}function Ol(t,e,n,i){let s=[],r=i.map(ny);for(let o=e;o<n;o++){let a=Ln(o),l=zt($o(t,o),a);for(let c=0;c<i.length;c++){let u=t==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=t==10?u:zt(u,h);s.push(f),mr.set(f,h)}}return s}var Fl={},Cp=[],Yo=[null,null],pr=Array.isArray,iy=Number.isInteger,nR=t=>t===void 0;function Tv(t){return typeof t=="string"}function Ph(t){let e=!1;if(t!=null){let n=t.constructor;e=n==null||n==Object}return e}function iR(t){return t!=null&&typeof t=="object"}var sR=Object.getPrototypeOf(Uint8Array),sy="__proto__";function Zo(t,e=Ph){let n;if(pr(t)){let i=t.find(s=>s!=null);if(pr(i)||e(i)){n=Array(t.length);for(let s=0;s<t.length;s++)n[s]=Zo(t[s],e)}else n=t.slice()}else if(t instanceof sR)n=t.slice();else if(e(t)){n={};for(let i in t)i!=sy&&(n[i]=Zo(t[i],e))}else n=t;return n}function wn(t){let e=arguments;for(let n=1;n<e.length;n++){let i=e[n];for(let s in i)s!=sy&&(Ph(t[s])?wn(t[s],Zo(i[s])):t[s]=Zo(i[s]))}return t}var rR=0,oR=1,aR=2;function lR(t,e,n){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&t[s]==null;)t[s--]=null;for(s=o+1;s<n&&t[s]==null;)t[r=s++]=null}}}function cR(t,e){if(fR(t)){let o=t[0].slice();for(let a=1;a<t.length;a++)o.push(...t[a].slice(1));return dR(o[0])||(o=hR(o)),o}let n=new Set;for(let o=0;o<t.length;o++){let l=t[o][0],c=l.length;for(let u=0;u<c;u++)n.add(l[u])}let i=[Array.from(n).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<t.length;o++){let a=t[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=e?e[o][c]:oR,d=[];for(let g=0;g<u.length;g++){let y=u[g],p=r.get(l[g]);y===null?f!=rR&&(h[p]=y,f==aR&&d.push(p)):h[p]=y}lR(h,d,s),i.push(h)}}return i}var uR=typeof queueMicrotask>"u"?t=>Promise.resolve().then(t):queueMicrotask;function hR(t){let e=t[0],n=e.length,i=Array(n);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<t.length;r++){let o=t[r],a=Array(n);for(let l=0;l<n;l++)a[l]=o[i[l]];s.push(a)}return s}function fR(t){let e=t[0][0],n=e.length;for(let i=1;i<t.length;i++){let s=t[i][0];if(s.length!=n)return!1;if(s!=e){for(let r=0;r<n;r++)if(s[r]!=e[r])return!1}}return!0}function dR(t,e=100){let n=t.length;if(n<=1)return!0;let i=0,s=n-1;for(;i<=s&&t[i]==null;)i++;for(;s>=i&&t[s]==null;)s--;if(s<=i)return!0;let r=ai(1,Si((s-i+1)/e));for(let o=t[i],a=i+r;a<=s;a+=r){let l=t[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var ry=["January","February","March","April","May","June","July","August","September","October","November","December"],oy=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function ay(t){return t.slice(0,3)}var pR=oy.map(ay),mR=ry.map(ay),gR={MMMM:ry,MMM:mR,WWWW:oy,WWW:pR};function Il(t){return(t<10?"0":"")+t}function _R(t){return(t<10?"00":t<100?"0":"")+t}var xR={YYYY:t=>t.getFullYear(),YY:t=>(t.getFullYear()+"").slice(2),MMMM:(t,e)=>e.MMMM[t.getMonth()],MMM:(t,e)=>e.MMM[t.getMonth()],MM:t=>Il(t.getMonth()+1),M:t=>t.getMonth()+1,DD:t=>Il(t.getDate()),D:t=>t.getDate(),WWWW:(t,e)=>e.WWWW[t.getDay()],WWW:(t,e)=>e.WWW[t.getDay()],HH:t=>Il(t.getHours()),H:t=>t.getHours(),h:t=>{let e=t.getHours();return e==0?12:e>12?e-12:e},AA:t=>t.getHours()>=12?"PM":"AM",aa:t=>t.getHours()>=12?"pm":"am",a:t=>t.getHours()>=12?"p":"a",mm:t=>Il(t.getMinutes()),m:t=>t.getMinutes(),ss:t=>Il(t.getSeconds()),s:t=>t.getSeconds(),fff:t=>_R(t.getMilliseconds())};function Rp(t,e){e=e||gR;let n=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(t);)n.push(s[0][0]=="{"?xR[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<n.length;a++)o+=typeof n[a]=="string"?n[a]:n[a](r,e);return o}}var vR=new Intl.DateTimeFormat().resolvedOptions().timeZone;function yR(t,e){let n;return e=="UTC"||e=="Etc/UTC"?n=new Date(+t+t.getTimezoneOffset()*6e4):e==vR?n=t:(n=new Date(t.toLocaleString("en-US",{timeZone:e})),n.setMilliseconds(t.getMilliseconds())),n}var ly=t=>t%1==0,Ah=[1,2,2.5,5],SR=Ol(10,-32,0,Ah),cy=Ol(10,0,32,Ah),MR=cy.filter(ly),Gr=SR.concat(cy),Pp=`
`,uy="{YYYY}",Cv=Pp+uy,hy="{M}/{D}",Dl=Pp+hy,Sh=Dl+"/{YY}",fy="{aa}",bR="{h}:{mm}",Xo=bR+fy,Rv=Pp+Xo,Pv=":{ss}",Pt=null;function dy(t){let e=t*1e3,n=e*60,i=n*60,s=i*24,r=s*30,o=s*365,l=(t==1?Ol(10,0,3,Ah).filter(ly):Ol(10,-3,0,Ah)).concat([e,e*5,e*10,e*15,e*30,n,n*5,n*10,n*15,n*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,uy,Pt,Pt,Pt,Pt,Pt,Pt,1],[s*28,"{MMM}",Cv,Pt,Pt,Pt,Pt,Pt,1],[s,hy,Cv,Pt,Pt,Pt,Pt,Pt,1],[i,"{h}"+fy,Sh,Pt,Dl,Pt,Pt,Pt,1],[n,Xo,Sh,Pt,Dl,Pt,Pt,Pt,1],[e,Pv,Sh+" "+Xo,Pt,Dl+" "+Xo,Pt,Rv,Pt,1],[t,Pv+".{fff}",Sh+" "+Xo,Pt,Dl+" "+Xo,Pt,Rv,Pt,1]];function u(h){return(f,d,g,y,p,m)=>{let v=[],T=p>=o,S=p>=r&&p<o,C=h(g),A=zt(C*t,3),_=cp(C.getFullYear(),T?0:C.getMonth(),S||T?1:C.getDate()),w=zt(_*t,3);if(S||T){let U=S?p/r:0,L=T?p/o:0,N=A==w?A:zt(cp(_.getFullYear()+L,_.getMonth()+U,1)*t,3),k=new Date(In(N/t)),H=k.getFullYear(),I=k.getMonth();for(let z=0;N<=y;z++){let $=cp(H+L*z,I+U*z,1),V=$-h(zt($*t,3));N=zt((+$+V)*t,3),N<=y&&v.push(N)}}else{let U=p>=s?s:p,L=Si(g)-Si(A),N=w+L+Rh(A-w,U);v.push(N);let k=h(N),H=k.getHours()+k.getMinutes()/n+k.getSeconds()/i,I=p/i,z=f.axes[d]._space,$=m/z;for(;N=zt(N+p,t==1?0:3),!(N>y);)if(I>1){let V=Si(zt(H+I,6))%24,K=h(N).getHours()-V;K>1&&(K=-1),N-=K*i,H=(H+I)%24;let ne=v[v.length-1];zt((N-ne)/p,3)*$>=.7&&v.push(N)}else v.push(N)}return v}}return[l,c,u]}var[wR,ER,AR]=dy(1),[TR,CR,RR]=dy(.001);Ol(2,-53,53,[1]);function Iv(t,e){return t.map(n=>n.map((i,s)=>s==0||s==8||i==null?i:e(s==1||n[8]==0?i:n[1]+i)))}function Lv(t,e){return(n,i,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,u,h,f,d;return i.map(g=>{let y=t(g),p=y.getFullYear(),m=y.getMonth(),v=y.getDate(),T=y.getHours(),S=y.getMinutes(),C=y.getSeconds(),A=p!=l&&a[2]||m!=c&&a[3]||v!=u&&a[4]||T!=h&&a[5]||S!=f&&a[6]||C!=d&&a[7]||a[1];return l=p,c=m,u=v,h=T,f=S,d=C,A(y)})}}function PR(t,e){let n=Rp(e);return(i,s,r,o,a)=>s.map(l=>n(t(l)))}function cp(t,e,n){return new Date(t,e,n)}function Nv(t,e){return e(t)}var IR="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Dv(t,e){return(n,i,s,r)=>r==null?bp:e(t(i))}function LR(t,e){let n=t.series[e];return n.width?n.stroke(t,e):n.points.width?n.points.stroke(t,e):null}function NR(t,e){return t.series[e].fill(t,e)}var DR={show:!0,live:!0,isolate:!1,mount:QC,markers:{show:!0,width:2,stroke:LR,fill:NR,dash:"solid"},idx:null,idxs:null,values:[]};function UR(t,e){let n=t.cursor.points,i=Ii(),s=n.size(t,e);Jt(i,Ll,s),Jt(i,Nl,s);let r=s/-2;Jt(i,"marginLeft",r),Jt(i,"marginTop",r);let o=n.width(t,e,s);return o&&Jt(i,"borderWidth",o),i}function FR(t,e){let n=t.series[e].points;return n._fill||n._stroke}function OR(t,e){let n=t.series[e].points;return n._stroke||n._fill}function BR(t,e){return t.series[e].points.size}var up=[0,0];function kR(t,e,n){return up[0]=e,up[1]=n,up}function Mh(t,e,n,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&n(s)}}function hp(t,e,n,i=!0){return s=>{(!i||s.target==e)&&n(s)}}var zR={show:!0,x:!0,y:!0,lock:!1,move:kR,points:{one:!1,show:UR,size:BR,width:0,stroke:OR,fill:FR},bind:{mousedown:Mh,mouseup:Mh,click:Mh,dblclick:Mh,mousemove:hp,mouseleave:hp,mouseenter:hp},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(t,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(t,e,n,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},py={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Ip=wn({},py,{filter:ey}),my=wn({},Ip,{size:10}),gy=wn({},py,{show:!1}),Lp='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',_y="bold "+Lp,xy=1.5,Uv={show:!0,scale:"x",stroke:Mp,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:_y,side:2,grid:Ip,ticks:my,border:gy,font:Lp,lineGap:xy,rotate:0},GR="Value",VR="Time",Fv={show:!0,scale:"x",auto:!1,sorted:1,min:kt,max:-kt,idxs:[]};function HR(t,e,n,i,s){return e.map(r=>r==null?"":Tp(r))}function WR(t,e,n,i,s,r,o){let a=[],l=mr.get(s)||0;n=o?n:zt(Rh(n,s),l);for(let c=n;c<=i;c=zt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function _p(t,e,n,i,s,r,o){let a=[],l=t.scales[t.axes[e].scale].log,c=l==10?zs:Jv,u=Si(c(n));s=$o(l,u),l==10&&(s=Gr[Ki(s,Gr)]);let h=n,f=s*l;l==10&&(f=Gr[Ki(f,Gr)]);do a.push(h),h=h+s,l==10&&!mr.has(h)&&(h=zt(h,mr.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=Gr[Ki(f,Gr)]));while(h<=i);return a}function XR(t,e,n,i,s,r,o){let l=t.scales[t.axes[e].scale].asinh,c=i>l?_p(t,e,ai(l,n),i,s):[l],u=i>=0&&n<=0?[0]:[];return(n<-l?_p(t,e,ai(l,-i),-n,s):[l]).reverse().map(f=>-f).concat(u,c)}var vy=/./,qR=/[12357]/,$R=/[125]/,Ov=/1/,xp=(t,e,n,i)=>t.map((s,r)=>e==4&&s==0||r%i==0&&n.test(s.toExponential()[s<0?1:0])?s:null);function YR(t,e,n,i,s){let r=t.axes[n],o=r.scale,a=t.scales[o],l=t.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?vy:l(7,o)-u>=c?qR:l(5,o)-u>=c?$R:Ov;if(h==Ov){let f=Ln(l(1,o)-u);if(f<c)return xp(e.slice().reverse(),a.distr,h,Li(c/f)).reverse()}return xp(e,a.distr,h,1)}function ZR(t,e,n,i,s){let r=t.axes[n],o=r.scale,a=r._space,l=t.valToPos,c=Ln(l(1,o)-l(2,o));return c<a?xp(e.slice().reverse(),3,vy,Li(a/c)).reverse():e}function jR(t,e,n,i){return i==null?bp:e==null?"":Tp(e)}var Bv={show:!0,scale:"y",stroke:Mp,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:_y,side:3,grid:Ip,ticks:my,border:gy,font:Lp,lineGap:xy,rotate:0};function JR(t,e){let n=3+(t||1)*2;return zt(n*e,3)}function KR(t,e){let{scale:n,idxs:i}=t.series[0],s=t._data[0],r=t.valToPos(s[i[0]],n,!0),o=t.valToPos(s[i[1]],n,!0),a=Ln(o-r),l=t.series[e],c=a/(l.points.space*Ct);return i[1]-i[0]<=c}var kv={scale:null,auto:!0,sorted:0,min:kt,max:-kt},yy=(t,e,n,i,s)=>s,zv={show:!0,auto:!0,sorted:0,gaps:yy,alpha:1,facets:[wn({},kv,{scale:"x"}),wn({},kv,{scale:"y"})]},Gv={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:yy,alpha:1,points:{show:KR,filter:null},values:null,min:kt,max:-kt,idxs:[],path:null,clip:null};function QR(t,e,n,i,s){return n/10}var Sy={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},eP=wn({},Sy,{time:!1,ori:1}),Vv={};function My(t,e){let n=Vv[t];return n||(n={key:t,plots:[],sub(i){n.plots.push(i)},unsub(i){n.plots=n.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<n.plots.length;u++)n.plots[u]!=s&&n.plots[u].pub(i,s,r,o,a,l,c)}},t!=null&&(Vv[t]=n)),n}var jo=1,vp=2;function Xr(t,e,n){let i=t.mode,s=t.series[e],r=i==2?t._data[e]:t._data,o=t.scales,a=t.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[t.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,g=a.width,y=a.height,p=t.valToPosH,m=t.valToPosV;return u.ori==0?n(s,l,c,u,h,p,m,f,d,g,y,Lh,Ko,Dh,wy,Ay):n(s,l,c,u,h,m,p,d,f,y,g,Nh,Qo,Up,Ey,Ty)}function Np(t,e){let n=0,i=0,s=Et(t.bands,Cp);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?n=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[n,i==1?-1:i==2?1:i==3?2:0]}function tP(t,e,n,i,s){let r=t.mode,o=t.series[e],a=r==2?o.facets[1].scale:o.scale,l=t.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Gs(t,e,n,i,s,r){return Xr(t,e,(o,a,l,c,u,h,f,d,g,y,p)=>{let m=o.pxRound,v=c.dir*(c.ori==0?1:-1),T=c.ori==0?Ko:Qo,S,C;v==1?(S=n,C=i):(S=i,C=n);let A=m(h(a[S],c,y,d)),_=m(f(l[S],u,p,g)),w=m(h(a[C],c,y,d)),U=m(f(r==1?u.max:u.min,u,p,g)),L=new Path2D(s);return T(L,w,U),T(L,A,U),T(L,A,_),L})}function Ih(t,e,n,i,s,r){let o=null;if(t.length>0){o=new Path2D;let a=e==0?Dh:Up,l=n;for(let h=0;h<t.length;h++){let f=t[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,i,d,i+r),l=f[1]}}let c=n+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function nP(t,e,n){let i=t[t.length-1];i&&i[0]==e?i[1]=n:t.push([e,n])}function Dp(t,e,n,i,s,r,o){let a=[],l=t.length;for(let c=s==1?n:i;c>=n&&c<=i;c+=s)if(e[c]===null){let h=c,f=c;if(s==1)for(;++c<=i&&e[c]===null;)f=c;else for(;--c>=n&&e[c]===null;)f=c;let d=r(t[h]),g=f==h?d:r(t[f]),y=h-s;d=o<=0&&y>=0&&y<l?r(t[y]):d;let m=f+s;g=o>=0&&m>=0&&m<l?r(t[m]):g,g>=d&&a.push([d,g])}return a}function Hv(t){return t==0?Qv:t==1?In:e=>zr(e,t)}function by(t){let e=t==0?Lh:Nh,n=t==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=t==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Qi(c,a/2,l/2),u=Qi(u,a/2,l/2),e(s,r+c,o),n(s,r+a,o,r+a,o+l,c),n(s,r+a,o+l,r,o+l,u),n(s,r,o+l,r,o,u),n(s,r,o,r+a,o,c),s.closePath())}}var Lh=(t,e,n)=>{t.moveTo(e,n)},Nh=(t,e,n)=>{t.moveTo(n,e)},Ko=(t,e,n)=>{t.lineTo(e,n)},Qo=(t,e,n)=>{t.lineTo(n,e)},Dh=by(0),Up=by(1),wy=(t,e,n,i,s,r)=>{t.arc(e,n,i,s,r)},Ey=(t,e,n,i,s,r)=>{t.arc(n,e,i,s,r)},Ay=(t,e,n,i,s,r,o)=>{t.bezierCurveTo(e,n,i,s,r,o)},Ty=(t,e,n,i,s,r,o)=>{t.bezierCurveTo(n,e,s,i,o,r)};function Cy(t){return(e,n,i,s,r)=>Xr(e,n,(o,a,l,c,u,h,f,d,g,y,p)=>{let{pxRound:m,points:v}=o,T,S;c.ori==0?(T=Lh,S=wy):(T=Nh,S=Ey);let C=zt(v.width*Ct,3),A=(v.size-v.width)/2*Ct,_=zt(A*2,3),w=new Path2D,U=new Path2D,{left:L,top:N,width:k,height:H}=e.bbox;Dh(U,L-_,N-_,k+_*2,H+_*2);let I=z=>{if(l[z]!=null){let $=m(h(a[z],c,y,d)),V=m(f(l[z],u,p,g));T(w,$+A,V),S(w,$,V,A,0,bh*2)}};if(r)r.forEach(I);else for(let z=i;z<=s;z++)I(z);return{stroke:C>0?w:null,fill:w,clip:U,flags:jo|vp}})}function Ry(t){return(e,n,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&t(e,n,i),r!=s&&o!=s&&t(e,n,s),t(e,n,o))}}var iP=Ry(Ko),sP=Ry(Qo);function Py(t){let e=Et(t?.alignGaps,0);return(n,i,s,r)=>Xr(n,i,(o,a,l,c,u,h,f,d,g,y,p)=>{[s,r]=Th(l,s,r);let m=o.pxRound,v=H=>m(h(H,c,y,d)),T=H=>m(f(H,u,p,g)),S,C;c.ori==0?(S=Ko,C=iP):(S=Qo,C=sP);let A=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:jo},w=_.stroke,U=!1;if(r-s>=y*4){let H=fe=>n.posToVal(fe,c.key,!0),I=null,z=null,$,V,ae,q=v(a[A==1?s:r]),K=v(a[s]),ne=v(a[r]),he=H(A==1?K+1:ne-1);for(let fe=A==1?s:r;fe>=s&&fe<=r;fe+=A){let Q=a[fe],xe=(A==1?Q<he:Q>he)?q:v(Q),Re=l[fe];xe==q?Re!=null?(V=Re,I==null?(S(w,xe,T(V)),$=I=z=V):V<I?I=V:V>z&&(z=V)):Re===null&&(U=!0):(I!=null&&C(w,q,T(I),T(z),T($),T(V)),Re!=null?(V=Re,S(w,xe,T(V)),I=z=$=V):(I=z=null,Re===null&&(U=!0)),q=xe,he=H(q+A))}I!=null&&I!=z&&ae!=q&&C(w,q,T(I),T(z),T($),T(V))}else for(let H=A==1?s:r;H>=s&&H<=r;H+=A){let I=l[H];I===null?U=!0:I!=null&&S(w,v(a[H]),T(I))}let[N,k]=Np(n,i);if(o.fill!=null||N!=0){let H=_.fill=new Path2D(w),I=o.fillTo(n,i,o.min,o.max,N),z=T(I),$=v(a[s]),V=v(a[r]);A==-1&&([V,$]=[$,V]),S(H,V,z),S(H,$,z)}if(!o.spanGaps){let H=[];U&&H.push(...Dp(a,l,s,r,A,v,e)),_.gaps=H=o.gaps(n,i,s,r,H),_.clip=Ih(H,c.ori,d,g,y,p)}return k!=0&&(_.band=k==2?[Gs(n,i,s,r,w,-1),Gs(n,i,s,r,w,1)]:Gs(n,i,s,r,w,k)),_})}function rP(t){let e=Et(t.align,1),n=Et(t.ascDesc,!1),i=Et(t.alignGaps,0),s=Et(t.extend,!1);return(r,o,a,l)=>Xr(r,o,(c,u,h,f,d,g,y,p,m,v,T)=>{[a,l]=Th(h,a,l);let S=c.pxRound,{left:C,width:A}=r.bbox,_=K=>S(g(K,f,v,p)),w=K=>S(y(K,d,T,m)),U=f.ori==0?Ko:Qo,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:jo},N=L.stroke,k=f.dir*(f.ori==0?1:-1),H=w(h[k==1?a:l]),I=_(u[k==1?a:l]),z=I,$=I;s&&e==-1&&($=C,U(N,$,H)),U(N,I,H);for(let K=k==1?a:l;K>=a&&K<=l;K+=k){let ne=h[K];if(ne==null)continue;let he=_(u[K]),fe=w(ne);e==1?U(N,he,H):U(N,z,fe),U(N,he,fe),H=fe,z=he}let V=z;s&&e==1&&(V=C+A,U(N,V,H));let[ae,q]=Np(r,o);if(c.fill!=null||ae!=0){let K=L.fill=new Path2D(N),ne=c.fillTo(r,o,c.min,c.max,ae),he=w(ne);U(K,V,he),U(K,$,he)}if(!c.spanGaps){let K=[];K.push(...Dp(u,h,a,l,k,_,i));let ne=c.width*Ct/2,he=n||e==1?ne:-ne,fe=n||e==-1?-ne:ne;K.forEach(Q=>{Q[0]+=he,Q[1]+=fe}),L.gaps=K=c.gaps(r,o,a,l,K),L.clip=Ih(K,f.ori,p,m,v,T)}return q!=0&&(L.band=q==2?[Gs(r,o,a,l,N,-1),Gs(r,o,a,l,N,1)]:Gs(r,o,a,l,N,q)),L})}function Wv(t,e,n,i,s,r,o=kt){if(t.length>1){let a=null;for(let l=0,c=1/0;l<t.length;l++)if(e[l]!==void 0){if(a!=null){let u=Ln(t[l]-t[a]);u<c&&(c=u,o=Ln(n(t[l],i,s,r)-n(t[a],i,s,r)))}a=l}}return o}function oP(t){t=t||Fl;let e=Et(t.size,[.6,kt,1]),n=t.align||0,i=t.gap||0,s=t.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=vt(s),o=1-e[0],a=Et(e[1],kt),l=Et(e[2],1),c=Et(t.disp,Fl),u=Et(t.each,d=>{}),{fill:h,stroke:f}=c;return(d,g,y,p)=>Xr(d,g,(m,v,T,S,C,A,_,w,U,L,N)=>{let k=m.pxRound,H=n,I=i*Ct,z=a*Ct,$=l*Ct,V,ae;S.ori==0?[V,ae]=r(d,g):[ae,V]=r(d,g);let q=S.dir*(S.ori==0?1:-1),K=S.ori==0?Dh:Up,ne=S.ori==0?u:(Ie,je,lt,Ee,Ot,Ve,Ye)=>{u(Ie,je,lt,Ot,Ee,Ye,Ve)},he=Et(d.bands,Cp).find(Ie=>Ie.series[0]==g),fe=he!=null?he.dir:0,Q=m.fillTo(d,g,m.min,m.max,fe),me=k(_(Q,C,N,U)),xe,Re,we,Xe=L,at=k(m.width*Ct),He=!1,dt=null,ut=null,rt=null,Kt=null;h!=null&&(at==0||f!=null)&&(He=!0,dt=h.values(d,g,y,p),ut=new Map,new Set(dt).forEach(Ie=>{Ie!=null&&ut.set(Ie,new Path2D)}),at>0&&(rt=f.values(d,g,y,p),Kt=new Map,new Set(rt).forEach(Ie=>{Ie!=null&&Kt.set(Ie,new Path2D)})));let{x0:Vt,size:_n}=c;if(Vt!=null&&_n!=null){H=1,v=Vt.values(d,g,y,p),Vt.unit==2&&(v=v.map(lt=>d.posToVal(w+lt*L,S.key,!0)));let Ie=_n.values(d,g,y,p);_n.unit==2?Re=Ie[0]*L:Re=A(Ie[0],S,L,w)-A(0,S,L,w),Xe=Wv(v,T,A,S,L,w,Xe),we=Xe-Re+I}else Xe=Wv(v,T,A,S,L,w,Xe),we=Xe*o+I,Re=Xe-we;we<1&&(we=0),at>=Re/2&&(at=0),we<5&&(k=Qv);let Ut=we>0,Nn=Xe-we-(Ut?at:0);Re=k(gp(Nn,$,z)),xe=(H==0?Re/2:H==q?0:Re)-H*q*((H==0?I/2:0)+(Ut?at/2:0));let Mt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},En=He?null:new Path2D,rn=null;if(he!=null)rn=d.data[he.series[1]];else{let{y0:Ie,y1:je}=c;Ie!=null&&je!=null&&(T=je.values(d,g,y,p),rn=Ie.values(d,g,y,p))}let xn=V*Re,B=ae*Re;for(let Ie=q==1?y:p;Ie>=y&&Ie<=p;Ie+=q){let je=T[Ie];if(je==null)continue;if(rn!=null){let X=rn[Ie]??0;if(je-X==0)continue;me=_(X,C,N,U)}let lt=S.distr!=2||c!=null?v[Ie]:Ie,Ee=A(lt,S,L,w),Ot=_(Et(je,Q),C,N,U),Ve=k(Ee-xe),Ye=k(ai(Ot,me)),R=k(Qi(Ot,me)),M=Ye-R;if(je!=null){let X=je<0?B:xn,ue=je<0?xn:B;He?(at>0&&rt[Ie]!=null&&K(Kt.get(rt[Ie]),Ve,R+Si(at/2),Re,ai(0,M-at),X,ue),dt[Ie]!=null&&K(ut.get(dt[Ie]),Ve,R+Si(at/2),Re,ai(0,M-at),X,ue)):K(En,Ve,R+Si(at/2),Re,ai(0,M-at),X,ue),ne(d,g,Ie,Ve-at/2,R,Re+at,M)}}return at>0?Mt.stroke=He?Kt:En:He||(Mt._fill=m.width==0?m._fill:m._stroke??m._fill,Mt.width=0),Mt.fill=He?ut:En,Mt})}function aP(t,e){let n=Et(e?.alignGaps,0);return(i,s,r,o)=>Xr(i,s,(a,l,c,u,h,f,d,g,y,p,m)=>{[r,o]=Th(c,r,o);let v=a.pxRound,T=V=>v(f(V,u,p,g)),S=V=>v(d(V,h,m,y)),C,A,_;u.ori==0?(C=Lh,_=Ko,A=Ay):(C=Nh,_=Qo,A=Ty);let w=u.dir*(u.ori==0?1:-1),U=T(l[w==1?r:o]),L=U,N=[],k=[];for(let V=w==1?r:o;V>=r&&V<=o;V+=w)if(c[V]!=null){let q=l[V],K=T(q);N.push(L=K),k.push(S(c[V]))}let H={stroke:t(N,k,C,_,A,v),fill:null,clip:null,band:null,gaps:null,flags:jo},I=H.stroke,[z,$]=Np(i,s);if(a.fill!=null||z!=0){let V=H.fill=new Path2D(I),ae=a.fillTo(i,s,a.min,a.max,z),q=S(ae);_(V,L,q),_(V,U,q)}if(!a.spanGaps){let V=[];V.push(...Dp(l,c,r,o,w,T,n)),H.gaps=V=a.gaps(i,s,r,o,V),H.clip=Ih(V,u.ori,g,y,p,m)}return $!=0&&(H.band=$==2?[Gs(i,s,r,o,I,-1),Gs(i,s,r,o,I,1)]:Gs(i,s,r,o,I,$)),H})}function lP(t){return aP(cP,t)}function cP(t,e,n,i,s,r){let o=t.length;if(o<2)return null;let a=new Path2D;if(n(a,t[0],e[0]),o==2)i(a,t[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=t[f+1]-t[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,t[f]+h[f]/3,e[f]+l[f]*h[f]/3,t[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,t[f+1],e[f+1])}return a}var yp=new Set;function Xv(){for(let t of yp)t.syncRect(!0)}Jo&&(Hr(HC,qo,Xv),Hr(WC,qo,Xv,!0),Hr(wh,qo,()=>{Hn.pxRatio=Ct}));var uP=Py(),hP=Cy();function qv(t,e,n,i){return(i?[t[0],t[1]].concat(t.slice(2)):[t[0]].concat(t.slice(1))).map((r,o)=>Sp(r,o,e,n))}function fP(t,e){return t.map((n,i)=>i==0?{}:wn({},e,n))}function Sp(t,e,n,i){return wn({},e==0?n:i,t)}function Iy(t,e,n){return e==null?Yo:[e,n]}var dP=Iy;function pP(t,e,n){return e==null?Yo:Eh(e,n,Ap,!0)}function Ly(t,e,n,i){return e==null?Yo:Ch(e,n,t.scales[i].log,!1)}var mP=Ly;function Ny(t,e,n,i){return e==null?Yo:Ep(e,n,t.scales[i].log,!1)}var gP=Ny;function _P(t,e,n,i,s){let r=ai(wv(t),wv(e)),o=e-t,a=Ki(s/i*o,n);do{let l=n[a],c=i*l/o;if(c>=s&&r+(l<5?mr.get(l):0)<=17)return[l,c]}while(++a<n.length);return[0,0]}function $v(t){let e,n;return t=t.replace(/(\d+)px/,(i,s)=>(e=In((n=+s)*Ct))+"px"),[t,e,n]}function xP(t){t.show&&[t.font,t.labelFont].forEach(e=>{let n=zt(e[2]*Ct,1);e[0]=e[0].replace(/[0-9.]+px/,n+"px"),e[1]=n})}function Hn(t,e,n){let i={mode:Et(t.mode,1)},s=i.mode;function r(x,b,P,D){let W=b.valToPct(x);return D+P*(b.dir==-1?1-W:W)}function o(x,b,P,D){let W=b.valToPct(x);return D+P*(b.dir==-1?W:1-W)}function a(x,b,P,D){return b.ori==0?r(x,b,P,D):o(x,b,P,D)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Ii(EC);if(t.id!=null&&(c.id=t.id),yi(c,t.class),t.title){let x=Ii(CC,c);x.textContent=t.title}let u=Ji("canvas"),h=i.ctx=u.getContext("2d"),f=Ii(RC,c);Hr("click",f,x=>{x.target===g&&(qt!=Kr||Qt!=Qr)&&Gn.click(i,x)},!0);let d=i.under=Ii(PC,f);f.appendChild(u);let g=i.over=Ii(IC,f);t=Zo(t);let y=+Et(t.pxAlign,1),p=Hv(y);(t.plugins||[]).forEach(x=>{x.opts&&(t=x.opts(i,t)||t)});let m=t.ms||.001,v=i.series=s==1?qv(t.series||[],Fv,Gv,!1):fP(t.series||[null],zv),T=i.axes=qv(t.axes||[],Uv,Bv,!0),S=i.scales={},C=i.bands=t.bands||[];C.forEach(x=>{x.fill=vt(x.fill||null),x.dir=Et(x.dir,-1)});let A=s==2?v[1].facets[0].scale:v[0].scale,_={axes:ys,series:mt},w=(t.drawOrder||["axes","series"]).map(x=>_[x]);function U(x){let b=x.distr==3?P=>zs(P>0?P:x.clamp(i,P,x.min,x.max,x.key)):x.distr==4?P=>lp(P,x.asinh):x.distr==100?P=>x.fwd(P):P=>P;return P=>{let D=b(P),{_min:W,_max:j}=x,oe=j-W;return(D-W)/oe}}function L(x){let b=S[x];if(b==null){let P=(t.scales||Fl)[x]||Fl;if(P.from!=null){L(P.from);let D=wn({},S[P.from],P,{key:x});D.valToPct=U(D),S[x]=D}else{b=S[x]=wn({},x==A?Sy:eP,P),b.key=x;let D=b.time,W=b.range,j=pr(W);if((x!=A||s==2&&!D)&&(j&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?Sv:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?Sv:{mode:1,hard:W[1],soft:W[1]}},j=!1),!j&&Ph(W))){let oe=W;W=(de,ye,Ue)=>ye==null?Yo:Eh(ye,Ue,oe)}b.range=vt(W||(D?dP:x==A?b.distr==3?mP:b.distr==4?gP:Iy:b.distr==3?Ly:b.distr==4?Ny:pP)),b.auto=vt(j?!1:b.auto),b.clamp=vt(b.clamp||QR),b._min=b._max=null,b.valToPct=U(b)}}}L("x"),L("y"),s==1&&v.forEach(x=>{L(x.scale)}),T.forEach(x=>{L(x.scale)});for(let x in t.scales)L(x);let N=S[A],k=N.distr,H,I;N.ori==0?(yi(c,AC),H=r,I=o):(yi(c,TC),H=o,I=r);let z={};for(let x in S){let b=S[x];(b.min!=null||b.max!=null)&&(z[x]={min:b.min,max:b.max},b.min=b.max=null)}let $=t.tzDate||(x=>new Date(In(x/m))),V=t.fmtDate||Rp,ae=m==1?AR($):RR($),q=Lv($,Iv(m==1?ER:CR,V)),K=Dv($,Nv(IR,V)),ne=[],he=i.legend=wn({},DR,t.legend),fe=i.cursor=wn({},zR,{drag:{y:s==2}},t.cursor),Q=he.show,me=fe.show,xe=he.markers;he.idxs=ne,xe.width=vt(xe.width),xe.dash=vt(xe.dash),xe.stroke=vt(xe.stroke),xe.fill=vt(xe.fill);let Re,we,Xe,at=[],He=[],dt,ut=!1,rt={};if(he.live){let x=v[1]?v[1].values:null;ut=x!=null,dt=ut?x(i,1,0):{_:0};for(let b in dt)rt[b]=bp}if(Q)if(Re=Ji("table",OC,c),Xe=Ji("tbody",null,Re),he.mount(i,Re),ut){we=Ji("thead",null,Re,Xe);let x=Ji("tr",null,we);Ji("th",null,x);for(var Kt in dt)Ji("th",lv,x).textContent=Kt}else yi(Re,kC),he.live&&yi(Re,BC);let Vt={show:!0},_n={show:!1};function Ut(x,b){if(b==0&&(ut||!he.live||s==2))return Yo;let P=[],D=Ji("tr",zC,Xe,Xe.childNodes[b]);yi(D,x.class),x.show||yi(D,Vr);let W=Ji("th",null,D);if(xe.show){let de=Ii(GC,W);if(b>0){let ye=xe.width(i,b);ye&&(de.style.border=ye+"px "+xe.dash(i,b)+" "+xe.stroke(i,b)),de.style.background=xe.fill(i,b)}}let j=Ii(lv,W);x.label instanceof HTMLElement?j.appendChild(x.label):j.textContent=x.label,b>0&&(xe.show||(j.style.color=x.width>0?xe.stroke(i,b):xe.fill(i,b)),Mt("click",W,de=>{if(fe._lock)return;Qe(de);let ye=v.indexOf(x);if((de.ctrlKey||de.metaKey)!=he.isolate){let Ue=v.some((Fe,Be)=>Be>0&&Be!=ye&&Fe.show);v.forEach((Fe,Be)=>{Be>0&&ss(Be,Ue?Be==ye?Vt:_n:Vt,!0,Mn.setSeries)})}else ss(ye,{show:!x.show},!0,Mn.setSeries)},!1),et&&Mt(fv,W,de=>{fe._lock||(Qe(de),ss(v.indexOf(x),to,!0,Mn.setSeries))},!1));for(var oe in dt){let de=Ji("td",VC,D);de.textContent="--",P.push(de)}return[D,P]}let Nn=new Map;function Mt(x,b,P,D=!0){let W=Nn.get(b)||{},j=fe.bind[x](i,b,P,D);j&&(Hr(x,b,W[x]=j),Nn.set(b,W))}function En(x,b,P){let D=Nn.get(b)||{};for(let W in D)(x==null||W==x)&&(mp(W,b,D[W]),delete D[W]);x==null&&Nn.delete(b)}let rn=0,xn=0,B=0,Ie=0,je=0,lt=0,Ee=je,Ot=lt,Ve=B,Ye=Ie,R=0,M=0,X=0,ue=0;i.bbox={};let re=!1,_e=!1,ve=!1,ee=!1,ie=!1,pe=!1;function O(x,b,P){(P||x!=i.width||b!=i.height)&&se(x,b),ht(!1),ve=!0,_e=!0,Wn()}function se(x,b){i.width=rn=B=x,i.height=xn=Ie=b,je=lt=0,be(),We();let P=i.bbox;R=P.left=zr(je*Ct,.5),M=P.top=zr(lt*Ct,.5),X=P.width=zr(B*Ct,.5),ue=P.height=zr(Ie*Ct,.5)}let te=3;function Ae(){let x=!1,b=0;for(;!x;){b++;let P=Zr(b),D=is(b);x=b==te||P&&D,x||(se(i.width,i.height),_e=!0)}}function ge({width:x,height:b}){O(x,b)}i.setSize=ge;function be(){let x=!1,b=!1,P=!1,D=!1;T.forEach((W,j)=>{if(W.show&&W._show){let{side:oe,_size:de}=W,ye=oe%2,Ue=W.label!=null?W.labelSize:0,Fe=de+Ue;Fe>0&&(ye?(B-=Fe,oe==3?(je+=Fe,D=!0):P=!0):(Ie-=Fe,oe==0?(lt+=Fe,x=!0):b=!0))}}),ts[0]=x,ts[1]=P,ts[2]=b,ts[3]=D,B-=Ui[1]+Ui[3],je+=Ui[3],Ie-=Ui[2]+Ui[0],lt+=Ui[0]}function We(){let x=je+B,b=lt+Ie,P=je,D=lt;function W(j,oe){switch(j){case 1:return x+=oe,x-oe;case 2:return b+=oe,b-oe;case 3:return P-=oe,P+oe;case 0:return D-=oe,D+oe}}T.forEach((j,oe)=>{if(j.show&&j._show){let de=j.side;j._pos=W(de,j._size),j.label!=null&&(j._lpos=W(de,j.labelSize))}})}if(fe.dataIdx==null){let x=fe.hover,b=x.skip=new Set(x.skip??[]);b.add(void 0);let P=x.prox=vt(x.prox),D=x.bias??=0;fe.dataIdx=(W,j,oe,de)=>{if(j==0)return oe;let ye=oe,Ue=P(W,j,oe,de)??kt,Fe=Ue>=0&&Ue<kt,Be=N.ori==0?B:Ie,ot=fe.left,At=e[0],bt=e[j];if(b.has(bt[oe])){ye=null;let gt=null,Ke=null,qe;if(D==0||D==-1)for(qe=oe;gt==null&&qe-- >0;)b.has(bt[qe])||(gt=qe);if(D==0||D==1)for(qe=oe;Ke==null&&qe++<bt.length;)b.has(bt[qe])||(Ke=qe);if(gt!=null||Ke!=null)if(Fe){let Yt=gt==null?-1/0:H(At[gt],N,Be,0),ln=Ke==null?1/0:H(At[Ke],N,Be,0),On=ot-Yt,Ft=ln-ot;On<=Ft?On<=Ue&&(ye=gt):Ft<=Ue&&(ye=Ke)}else ye=Ke==null?gt:gt==null?Ke:oe-gt<=Ke-oe?gt:Ke}else Fe&&Ln(ot-H(At[oe],N,Be,0))>Ue&&(ye=null);return ye}}let Qe=x=>{fe.event=x};fe.idxs=ne,fe._lock=!1;let ce=fe.points;ce.show=vt(ce.show),ce.size=vt(ce.size),ce.stroke=vt(ce.stroke),ce.width=vt(ce.width),ce.fill=vt(ce.fill);let ke=i.focus=wn({},t.focus||{alpha:.3},fe.focus),et=ke.prox>=0,Pe=et&&ce.one,ct=[],Xt=[],Jn=[];function aa(x,b){let P=ce.show(i,b);if(P instanceof HTMLElement)return yi(P,FC),yi(P,x.class),ms(P,-10,-10,B,Ie),g.insertBefore(P,ct[b]),P}function qr(x,b){if(s==1||b>0){let P=s==1&&S[x.scale].time,D=x.value;x.value=P?Tv(D)?Dv($,Nv(D,V)):D||K:D||jR,x.label=x.label||(P?VR:GR)}if(Pe||b>0){x.width=x.width==null?1:x.width,x.paths=x.paths||uP||eR,x.fillTo=vt(x.fillTo||tP),x.pxAlign=+Et(x.pxAlign,y),x.pxRound=Hv(x.pxAlign),x.stroke=vt(x.stroke||null),x.fill=vt(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let P=JR(ai(1,x.width),1),D=x.points=wn({},{size:P,width:ai(1,P*.2),stroke:x.stroke,space:P*2,paths:hP,_stroke:null,_fill:null},x.points);D.show=vt(D.show),D.filter=vt(D.filter),D.fill=vt(D.fill),D.stroke=vt(D.stroke),D.paths=vt(D.paths),D.pxAlign=x.pxAlign}if(Q){let P=Ut(x,b);at.splice(b,0,P[0]),He.splice(b,0,P[1]),he.values.push(null)}if(me){ne.splice(b,0,null);let P=null;Pe?b==0&&(P=aa(x,b)):b>0&&(P=aa(x,b)),ct.splice(b,0,P),Xt.splice(b,0,0),Jn.splice(b,0,0)}Fn("addSeries",b)}function zh(x,b){b=b??v.length,x=s==1?Sp(x,b,Fv,Gv):Sp(x,b,{},zv),v.splice(b,0,x),qr(v[b],b)}i.addSeries=zh;function Vl(x){if(v.splice(x,1),Q){he.values.splice(x,1),He.splice(x,1);let b=at.splice(x,1)[0];En(null,b.firstChild),b.remove()}me&&(ne.splice(x,1),ct.splice(x,1)[0].remove(),Xt.splice(x,1),Jn.splice(x,1)),Fn("delSeries",x)}i.delSeries=Vl;let ts=[!1,!1,!1,!1];function _s(x,b){if(x._show=x.show,x.show){let P=x.side%2,D=S[x.scale];D==null&&(x.scale=P?v[1].scale:A,D=S[x.scale]);let W=D.time;x.size=vt(x.size),x.space=vt(x.space),x.rotate=vt(x.rotate),pr(x.incrs)&&x.incrs.forEach(oe=>{!mr.has(oe)&&mr.set(oe,ny(oe))}),x.incrs=vt(x.incrs||(D.distr==2?MR:W?m==1?wR:TR:Gr)),x.splits=vt(x.splits||(W&&D.distr==1?ae:D.distr==3?_p:D.distr==4?XR:WR)),x.stroke=vt(x.stroke),x.grid.stroke=vt(x.grid.stroke),x.ticks.stroke=vt(x.ticks.stroke),x.border.stroke=vt(x.border.stroke);let j=x.values;x.values=pr(j)&&!pr(j[0])?vt(j):W?pr(j)?Lv($,Iv(j,V)):Tv(j)?PR($,j):j||q:j||HR,x.filter=vt(x.filter||(D.distr>=3&&D.log==10?YR:D.distr==3&&D.log==2?ZR:ey)),x.font=$v(x.font),x.labelFont=$v(x.labelFont),x._size=x.size(i,null,b,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(ts[b]=!0,x._el=Ii(LC,f))}}function xs(x,b,P,D){let[W,j,oe,de]=P,ye=b%2,Ue=0;return ye==0&&(de||j)&&(Ue=b==0&&!W||b==2&&!oe?In(Uv.size/3):0),ye==1&&(W||oe)&&(Ue=b==1&&!j||b==3&&!de?In(Bv.size/2):0),Ue}let la=i.padding=(t.padding||[xs,xs,xs,xs]).map(x=>vt(Et(x,xs))),Ui=i._padding=la.map((x,b)=>x(i,b,ts,0)),on,pn=null,mn=null,ns=s==1?v[0].idxs:null,ui=null,Hs=!1;function ca(x,b){if(e=x??[],i.data=i._data=e,s==2){on=0;for(let P=1;P<v.length;P++)on+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),ui=e[0],on=ui.length;let P=e;if(k==2){P=e.slice();let D=P[0]=Array(on);for(let W=0;W<on;W++)D[W]=W}i._data=e=P}if(ht(!0),Fn("setData"),k==2&&(ve=!0),b!==!1){let P=N;P.auto(i,Hs)?ua():qs(A,P.min,P.max),ee=ee||fe.left>=0,pe=!0,Wn()}}i.setData=ca;function ua(){Hs=!0;let x,b;s==1&&(on>0?(pn=ns[0]=0,mn=ns[1]=on-1,x=e[0][pn],b=e[0][mn],k==2?(x=pn,b=mn):x==b&&(k==3?[x,b]=Ch(x,x,N.log,!1):k==4?[x,b]=Ep(x,x,N.log,!1):N.time?b=x+In(86400/m):[x,b]=Eh(x,b,Ap,!0))):(pn=ns[0]=x=null,mn=ns[1]=b=null)),qs(A,x,b)}let $r,Ws,Yr,E,G,J,Y,Z,Te,Le;function Ce(x,b,P,D,W,j){x??=uv,P??=Cp,D??="butt",W??=uv,j??="round",x!=$r&&(h.strokeStyle=$r=x),W!=Ws&&(h.fillStyle=Ws=W),b!=Yr&&(h.lineWidth=Yr=b),j!=G&&(h.lineJoin=G=j),D!=J&&(h.lineCap=J=D),P!=E&&h.setLineDash(E=P)}function Ne(x,b,P,D){b!=Ws&&(h.fillStyle=Ws=b),x!=Y&&(h.font=Y=x),P!=Z&&(h.textAlign=Z=P),D!=Te&&(h.textBaseline=Te=D)}function Ge(x,b,P,D,W=0){if(D.length>0&&x.auto(i,Hs)&&(b==null||b.min==null)){let j=Et(pn,0),oe=Et(mn,D.length-1),de=P.min==null?YC(D,j,oe,W,x.distr==3):[P.min,P.max];x.min=Qi(x.min,P.min=de[0]),x.max=ai(x.max,P.max=de[1])}}let nt={min:null,max:null};function pt(){for(let D in S){let W=S[D];z[D]==null&&(W.min==null||z[A]!=null&&W.auto(i,Hs))&&(z[D]=nt)}for(let D in S){let W=S[D];z[D]==null&&W.from!=null&&z[W.from]!=null&&(z[D]=nt)}z[A]!=null&&ht(!0);let x={};for(let D in z){let W=z[D];if(W!=null){let j=x[D]=Zo(S[D],iR);if(W.min!=null)wn(j,W);else if(D!=A||s==2)if(on==0&&j.from==null){let oe=j.range(i,null,null,D);j.min=oe[0],j.max=oe[1]}else j.min=kt,j.max=-kt}}if(on>0){v.forEach((D,W)=>{if(s==1){let j=D.scale,oe=z[j];if(oe==null)return;let de=x[j];if(W==0){let ye=de.range(i,de.min,de.max,j);de.min=ye[0],de.max=ye[1],pn=Ki(de.min,e[0]),mn=Ki(de.max,e[0]),mn-pn>1&&(e[0][pn]<de.min&&pn++,e[0][mn]>de.max&&mn--),D.min=ui[pn],D.max=ui[mn]}else D.show&&D.auto&&Ge(de,oe,D,e[W],D.sorted);D.idxs[0]=pn,D.idxs[1]=mn}else if(W>0&&D.show&&D.auto){let[j,oe]=D.facets,de=j.scale,ye=oe.scale,[Ue,Fe]=e[W],Be=x[de],ot=x[ye];Be!=null&&Ge(Be,z[de],j,Ue,j.sorted),ot!=null&&Ge(ot,z[ye],oe,Fe,oe.sorted),D.min=oe.min,D.max=oe.max}});for(let D in x){let W=x[D],j=z[D];if(W.from==null&&(j==null||j.min==null)){let oe=W.range(i,W.min==kt?null:W.min,W.max==-kt?null:W.max,D);W.min=oe[0],W.max=oe[1]}}}for(let D in x){let W=x[D];if(W.from!=null){let j=x[W.from];if(j.min==null)W.min=W.max=null;else{let oe=W.range(i,j.min,j.max,D);W.min=oe[0],W.max=oe[1]}}}let b={},P=!1;for(let D in x){let W=x[D],j=S[D];if(j.min!=W.min||j.max!=W.max){j.min=W.min,j.max=W.max;let oe=j.distr;j._min=oe==3?zs(j.min):oe==4?lp(j.min,j.asinh):oe==100?j.fwd(j.min):j.min,j._max=oe==3?zs(j.max):oe==4?lp(j.max,j.asinh):oe==100?j.fwd(j.max):j.max,b[D]=P=!0}}if(P){v.forEach((D,W)=>{s==2?W>0&&b.y&&(D._paths=null):b[D.scale]&&(D._paths=null)});for(let D in b)ve=!0,Fn("setScale",D);me&&fe.left>=0&&(ee=pe=!0)}for(let D in z)z[D]=null}function ze(x){let b=gp(pn-1,0,on-1),P=gp(mn+1,0,on-1);for(;x[b]==null&&b>0;)b--;for(;x[P]==null&&P<on-1;)P++;return[b,P]}function mt(){if(on>0){let x=v.some(b=>b._focus)&&Le!=ke.alpha;x&&(h.globalAlpha=Le=ke.alpha),v.forEach((b,P)=>{if(P>0&&b.show&&(sn(P,!1),sn(P,!0),b._paths==null)){let D=Le;Le!=b.alpha&&(h.globalAlpha=Le=b.alpha);let W=s==2?[0,e[P][0].length-1]:ze(e[P]);b._paths=b.paths(i,P,W[0],W[1]),Le!=D&&(h.globalAlpha=Le=D)}}),v.forEach((b,P)=>{if(P>0&&b.show){let D=Le;Le!=b.alpha&&(h.globalAlpha=Le=b.alpha),b._paths!=null&&It(P,!1);{let W=b._paths!=null?b._paths.gaps:null,j=b.points.show(i,P,pn,mn,W),oe=b.points.filter(i,P,j,W);(j||oe)&&(b.points._paths=b.points.paths(i,P,pn,mn,oe),It(P,!0))}Le!=D&&(h.globalAlpha=Le=D),Fn("drawSeries",P)}}),x&&(h.globalAlpha=Le=1)}}function sn(x,b){let P=b?v[x].points:v[x];P._stroke=P.stroke(i,x),P._fill=P.fill(i,x)}function It(x,b){let P=b?v[x].points:v[x],{stroke:D,fill:W,clip:j,flags:oe,_stroke:de=P._stroke,_fill:ye=P._fill,_width:Ue=P.width}=P._paths;Ue=zt(Ue*Ct,3);let Fe=null,Be=Ue%2/2;b&&ye==null&&(ye=Ue>0?"#fff":de);let ot=P.pxAlign==1&&Be>0;if(ot&&h.translate(Be,Be),!b){let At=R-Ue/2,bt=M-Ue/2,gt=X+Ue,Ke=ue+Ue;Fe=new Path2D,Fe.rect(At,bt,gt,Ke)}b?Oe(de,Ue,P.dash,P.cap,ye,D,W,oe,j):Lt(x,de,Ue,P.dash,P.cap,ye,D,W,oe,Fe,j),ot&&h.translate(-Be,-Be)}function Lt(x,b,P,D,W,j,oe,de,ye,Ue,Fe){let Be=!1;ye!=0&&C.forEach((ot,At)=>{if(ot.series[0]==x){let bt=v[ot.series[1]],gt=e[ot.series[1]],Ke=(bt._paths||Fl).band;pr(Ke)&&(Ke=ot.dir==1?Ke[0]:Ke[1]);let qe,Yt=null;bt.show&&Ke&&jC(gt,pn,mn)?(Yt=ot.fill(i,At)||j,qe=bt._paths.clip):Ke=null,Oe(b,P,D,W,Yt,oe,de,ye,Ue,Fe,qe,Ke),Be=!0}}),Be||Oe(b,P,D,W,j,oe,de,ye,Ue,Fe)}let An=jo|vp;function Oe(x,b,P,D,W,j,oe,de,ye,Ue,Fe,Be){Ce(x,b,P,D,W),(ye||Ue||Be)&&(h.save(),ye&&h.clip(ye),Ue&&h.clip(Ue)),Be?(de&An)==An?(h.clip(Be),Fe&&h.clip(Fe),_t(W,oe),vn(x,j,b)):de&vp?(_t(W,oe),h.clip(Be),vn(x,j,b)):de&jo&&(h.save(),h.clip(Be),Fe&&h.clip(Fe),_t(W,oe),h.restore(),vn(x,j,b)):(_t(W,oe),vn(x,j,b)),(ye||Ue||Be)&&h.restore()}function vn(x,b,P){P>0&&(b instanceof Map?b.forEach((D,W)=>{h.strokeStyle=$r=W,h.stroke(D)}):b!=null&&x&&h.stroke(b))}function _t(x,b){b instanceof Map?b.forEach((P,D)=>{h.fillStyle=Ws=D,h.fill(P)}):b!=null&&x&&h.fill(b)}function vs(x,b,P,D){let W=T[x],j;if(D<=0)j=[0,0];else{let oe=W._space=W.space(i,x,b,P,D),de=W._incrs=W.incrs(i,x,b,P,D,oe);j=_P(b,P,de,D,oe)}return W._found=j}function yn(x,b,P,D,W,j,oe,de,ye,Ue){let Fe=oe%2/2;y==1&&h.translate(Fe,Fe),Ce(de,oe,ye,Ue,de),h.beginPath();let Be,ot,At,bt,gt=W+(D==0||D==3?-j:j);P==0?(ot=W,bt=gt):(Be=W,At=gt);for(let Ke=0;Ke<x.length;Ke++)b[Ke]!=null&&(P==0?Be=At=x[Ke]:ot=bt=x[Ke],h.moveTo(Be,ot),h.lineTo(At,bt));h.stroke(),y==1&&h.translate(-Fe,-Fe)}function Zr(x){let b=!0;return T.forEach((P,D)=>{if(!P.show)return;let W=S[P.scale];if(W.min==null){P._show&&(b=!1,P._show=!1,ht(!1));return}else P._show||(b=!1,P._show=!0,ht(!1));let j=P.side,oe=j%2,{min:de,max:ye}=W,[Ue,Fe]=vs(D,de,ye,oe==0?B:Ie);if(Fe==0)return;let Be=W.distr==2,ot=P._splits=P.splits(i,D,de,ye,Ue,Fe,Be),At=W.distr==2?ot.map(qe=>ui[qe]):ot,bt=W.distr==2?ui[ot[1]]-ui[ot[0]]:Ue,gt=P._values=P.values(i,P.filter(i,At,D,Fe,bt),D,Fe,bt);P._rotate=j==2?P.rotate(i,gt,D,Fe):0;let Ke=P._size;P._size=Li(P.size(i,gt,D,x)),Ke!=null&&P._size!=Ke&&(b=!1)}),b}function is(x){let b=!0;return la.forEach((P,D)=>{let W=P(i,D,ts,x);W!=Ui[D]&&(b=!1),Ui[D]=W}),b}function ys(){for(let x=0;x<T.length;x++){let b=T[x];if(!b.show||!b._show)continue;let P=b.side,D=P%2,W,j,oe=b.stroke(i,x),de=P==0||P==3?-1:1,[ye,Ue]=b._found;if(b.label!=null){let ei=b.labelGap*de,di=In((b._lpos+ei)*Ct);Ne(b.labelFont[0],oe,"center",P==2?"top":cv),h.save(),D==1?(W=j=0,h.translate(di,In(M+ue/2)),h.rotate((P==3?-bh:bh)/2)):(W=In(R+X/2),j=di);let yr=Kv(b.label)?b.label(i,x,ye,Ue):b.label;h.fillText(yr,W,j),h.restore()}if(Ue==0)continue;let Fe=S[b.scale],Be=D==0?X:ue,ot=D==0?R:M,At=b._splits,bt=Fe.distr==2?At.map(ei=>ui[ei]):At,gt=Fe.distr==2?ui[At[1]]-ui[At[0]]:ye,Ke=b.ticks,qe=b.border,Yt=Ke.show?Ke.size:0,ln=In(Yt*Ct),On=In((b.alignTo==2?b._size-Yt-b.gap:b.gap)*Ct),Ft=b._rotate*-bh/180,cn=p(b._pos*Ct),hi=(ln+On)*de,Qn=cn+hi;j=D==0?Qn:0,W=D==1?Qn:0;let wi=b.font[0],Fi=b.align==1?Wo:b.align==2?rp:Ft>0?Wo:Ft<0?rp:D==0?"center":P==3?rp:Wo,os=Ft||D==1?"middle":P==2?"top":cv;Ne(wi,oe,Fi,os);let fi=b.font[1]*b.lineGap,Ei=At.map(ei=>p(a(ei,Fe,Be,ot))),Oi=b._values;for(let ei=0;ei<Oi.length;ei++){let di=Oi[ei];if(di!=null){D==0?W=Ei[ei]:j=Ei[ei],di=""+di;let yr=di.indexOf(`
`)==-1?[di]:di.split(/\n/gm);for(let ti=0;ti<yr.length;ti++){let ym=yr[ti];Ft?(h.save(),h.translate(W,j+ti*fi),h.rotate(Ft),h.fillText(ym,0,0),h.restore()):h.fillText(ym,W,j+ti*fi)}}}Ke.show&&yn(Ei,Ke.filter(i,bt,x,Ue,gt),D,P,cn,ln,zt(Ke.width*Ct,3),Ke.stroke(i,x),Ke.dash,Ke.cap);let as=b.grid;as.show&&yn(Ei,as.filter(i,bt,x,Ue,gt),D,D==0?2:1,D==0?M:R,D==0?ue:X,zt(as.width*Ct,3),as.stroke(i,x),as.dash,as.cap),qe.show&&yn([cn],[1],D==0?1:0,D==0?1:2,D==1?M:R,D==1?ue:X,zt(qe.width*Ct,3),qe.stroke(i,x),qe.dash,qe.cap)}Fn("drawAxes")}function ht(x){v.forEach((b,P)=>{P>0&&(b._paths=null,x&&(s==1?(b.min=null,b.max=null):b.facets.forEach(D=>{D.min=null,D.max=null})))})}let an=!1,Kn=!1,Nt=[];function Sn(){Kn=!1;for(let x=0;x<Nt.length;x++)Fn(...Nt[x]);Nt.length=0}function Wn(){an||(uR(nm),an=!0)}function Hl(x,b=!1){an=!0,Kn=b,x(i),nm(),b&&Nt.length>0&&queueMicrotask(Sn)}i.batch=Hl;function nm(){if(re&&(pt(),re=!1),ve&&(Ae(),ve=!1),_e){if(Jt(d,Wo,je),Jt(d,"top",lt),Jt(d,Ll,B),Jt(d,Nl,Ie),Jt(g,Wo,je),Jt(g,"top",lt),Jt(g,Ll,B),Jt(g,Nl,Ie),Jt(f,Ll,rn),Jt(f,Nl,xn),u.width=In(rn*Ct),u.height=In(xn*Ct),T.forEach(({_el:x,_show:b,_size:P,_pos:D,side:W})=>{if(x!=null)if(b){let j=W===3||W===0?P:0,oe=W%2==1;Jt(x,oe?"left":"top",D-j),Jt(x,oe?"width":"height",P),Jt(x,oe?"top":"left",oe?lt:je),Jt(x,oe?"height":"width",oe?Ie:B),pp(x,Vr)}else yi(x,Vr)}),$r=Ws=Yr=G=J=Y=Z=Te=E=null,Le=1,da(!0),je!=Ee||lt!=Ot||B!=Ve||Ie!=Ye){ht(!1);let x=B/Ve,b=Ie/Ye;if(me&&!ee&&fe.left>=0){fe.left*=x,fe.top*=b,jr&&ms(jr,In(fe.left),0,B,Ie),Jr&&ms(Jr,0,In(fe.top),B,Ie);for(let P=0;P<ct.length;P++){let D=ct[P];D!=null&&(Xt[P]*=x,Jn[P]*=b,ms(D,Li(Xt[P]),Li(Jn[P]),B,Ie))}}if($t.show&&!ie&&$t.left>=0&&$t.width>0){$t.left*=x,$t.width*=x,$t.top*=b,$t.height*=b;for(let P in qh)Jt(eo,P,$t[P])}Ee=je,Ot=lt,Ve=B,Ye=Ie}Fn("setSize"),_e=!1}rn>0&&xn>0&&(h.clearRect(0,0,u.width,u.height),Fn("drawClear"),w.forEach(x=>x()),Fn("draw")),$t.show&&ie&&(Wl($t),ie=!1),me&&ee&&(vr(null,!0,!1),ee=!1),he.show&&he.live&&pe&&(Wh(),pe=!1),l||(l=!0,i.status=1,Fn("ready")),Hs=!1,an=!1}i.redraw=(x,b)=>{ve=b||!1,x!==!1?qs(A,N.min,N.max):Wn()};function Gh(x,b){let P=S[x];if(P.from==null){if(on==0){let D=P.range(i,b.min,b.max,x);b.min=D[0],b.max=D[1]}if(b.min>b.max){let D=b.min;b.min=b.max,b.max=D}if(on>1&&b.min!=null&&b.max!=null&&b.max-b.min<1e-16)return;x==A&&P.distr==2&&on>0&&(b.min=Ki(b.min,e[0]),b.max=Ki(b.max,e[0]),b.min==b.max&&b.max++),z[x]=b,re=!0,Wn()}}i.setScale=Gh;let Vh,Hh,jr,Jr,im,sm,Kr,Qr,rm,om,qt,Qt,Xs=!1,Gn=fe.drag,Dn=Gn.x,Un=Gn.y;me&&(fe.x&&(Vh=Ii(DC,g)),fe.y&&(Hh=Ii(UC,g)),N.ori==0?(jr=Vh,Jr=Hh):(jr=Hh,Jr=Vh),qt=fe.left,Qt=fe.top);let $t=i.select=wn({show:!0,over:!0,left:0,width:0,top:0,height:0},t.select),eo=$t.show?Ii(NC,$t.over?g:d):null;function Wl(x,b){if($t.show){for(let P in x)$t[P]=x[P],P in qh&&Jt(eo,P,x[P]);b!==!1&&Fn("setSelect")}}i.setSelect=Wl;function oM(x){if(v[x].show)Q&&pp(at[x],Vr);else if(Q&&yi(at[x],Vr),me){let P=Pe?ct[0]:ct[x];P!=null&&ms(P,-10,-10,B,Ie)}}function qs(x,b,P){Gh(x,{min:b,max:P})}function ss(x,b,P,D){b.focus!=null&&hM(x),b.show!=null&&v.forEach((W,j)=>{j>0&&(x==j||x==null)&&(W.show=b.show,oM(j),s==2?(qs(W.facets[0].scale,null,null),qs(W.facets[1].scale,null,null)):qs(W.scale,null,null),Wn())}),P!==!1&&Fn("setSeries",x,b),D&&pa("setSeries",i,x,b)}i.setSeries=ss;function aM(x,b){wn(C[x],b)}function lM(x,b){x.fill=vt(x.fill||null),x.dir=Et(x.dir,-1),b=b??C.length,C.splice(b,0,x)}function cM(x){x==null?C.length=0:C.splice(x,1)}i.addBand=lM,i.setBand=aM,i.delBand=cM;function uM(x,b){v[x].alpha=b,me&&ct[x]!=null&&(ct[x].style.opacity=b),Q&&at[x]&&(at[x].style.opacity=b)}let Ss,$s,xr,to={focus:!0};function hM(x){if(x!=xr){let b=x==null,P=ke.alpha!=1;v.forEach((D,W)=>{if(s==1||W>0){let j=b||W==0||W==x;D._focus=b?null:j,P&&uM(W,j?1:ke.alpha)}}),xr=x,P&&Wn()}}Q&&et&&Mt(dv,Re,x=>{fe._lock||(Qe(x),xr!=null&&ss(null,to,!0,Mn.setSeries))});function rs(x,b,P){let D=S[b];P&&(x=x/Ct-(D.ori==1?lt:je));let W=B;D.ori==1&&(W=Ie,x=W-x),D.dir==-1&&(x=W-x);let j=D._min,oe=D._max,de=x/W,ye=j+(oe-j)*de,Ue=D.distr;return Ue==3?$o(10,ye):Ue==4?KC(ye,D.asinh):Ue==100?D.bwd(ye):ye}function fM(x,b){let P=rs(x,A,b);return Ki(P,e[0],pn,mn)}i.valToIdx=x=>Ki(x,e[0]),i.posToIdx=fM,i.posToVal=rs,i.valToPos=(x,b,P)=>S[b].ori==0?r(x,S[b],P?X:B,P?R:0):o(x,S[b],P?ue:Ie,P?M:0),i.setCursor=(x,b,P)=>{qt=x.left,Qt=x.top,vr(null,b,P)};function am(x,b){Jt(eo,Wo,$t.left=x),Jt(eo,Ll,$t.width=b)}function lm(x,b){Jt(eo,"top",$t.top=x),Jt(eo,Nl,$t.height=b)}let ha=N.ori==0?am:lm,fa=N.ori==1?am:lm;function dM(){if(Q&&he.live)for(let x=s==2?1:0;x<v.length;x++){if(x==0&&ut)continue;let b=he.values[x],P=0;for(let D in b)He[x][P++].firstChild.nodeValue=b[D]}}function Wh(x,b){if(x!=null&&(x.idxs?x.idxs.forEach((P,D)=>{ne[D]=P}):nR(x.idx)||ne.fill(x.idx),he.idx=ne[0]),Q&&he.live){for(let P=0;P<v.length;P++)(P>0||s==1&&!ut)&&pM(P,ne[P]);dM()}pe=!1,b!==!1&&Fn("setLegend")}i.setLegend=Wh;function pM(x,b){let P=v[x],D=x==0&&k==2?ui:e[x],W;ut?W=P.values(i,x,b)??rt:(W=P.value(i,b==null?null:D[b],x,b),W=W==null?rt:{_:W}),he.values[x]=W}function vr(x,b,P){rm=qt,om=Qt,[qt,Qt]=fe.move(i,qt,Qt),fe.left=qt,fe.top=Qt,me&&(jr&&ms(jr,In(qt),0,B,Ie),Jr&&ms(Jr,0,In(Qt),B,Ie));let D,W=pn>mn;Ss=kt,$s=null;let j=N.ori==0?B:Ie,oe=N.ori==1?B:Ie;if(qt<0||on==0||W){D=fe.idx=null;for(let de=0;de<v.length;de++){let ye=ct[de];ye!=null&&ms(ye,-10,-10,B,Ie)}et&&ss(null,to,!0,x==null&&Mn.setSeries),he.live&&(ne.fill(D),pe=!0)}else{let de,ye,Ue;s==1&&(de=N.ori==0?qt:Qt,ye=rs(de,A),D=fe.idx=Ki(ye,e[0],pn,mn),Ue=H(e[0][D],N,j,0));let Fe=-10,Be=-10,ot=0,At=0,bt=!0,gt="",Ke="";for(let qe=s==2?1:0;qe<v.length;qe++){let Yt=v[qe],ln=ne[qe],On=ln==null?null:s==1?e[qe][ln]:e[qe][1][ln],Ft=fe.dataIdx(i,qe,D,ye),cn=Ft==null?null:s==1?e[qe][Ft]:e[qe][1][Ft];if(pe=pe||cn!=On||Ft!=ln,ne[qe]=Ft,qe>0&&Yt.show){let hi=Ft==null?-10:Ft==D?Ue:H(s==1?e[0][Ft]:e[qe][0][Ft],N,j,0),Qn=cn==null?-10:I(cn,s==1?S[Yt.scale]:S[Yt.facets[1].scale],oe,0);if(et&&cn!=null){let wi=N.ori==1?qt:Qt,Fi=Ln(ke.dist(i,qe,Ft,Qn,wi));if(Fi<Ss){let os=ke.bias;if(os!=0){let fi=rs(wi,Yt.scale),Ei=cn>=0?1:-1,Oi=fi>=0?1:-1;Oi==Ei&&(Oi==1?os==1?cn>=fi:cn<=fi:os==1?cn<=fi:cn>=fi)&&(Ss=Fi,$s=qe)}else Ss=Fi,$s=qe}}if(pe||Pe){let wi,Fi;N.ori==0?(wi=hi,Fi=Qn):(wi=Qn,Fi=hi);let os,fi,Ei,Oi,as,ei,di=!0,yr=ce.bbox;if(yr!=null){di=!1;let ti=yr(i,qe);Ei=ti.left,Oi=ti.top,os=ti.width,fi=ti.height}else Ei=wi,Oi=Fi,os=fi=ce.size(i,qe);if(ei=ce.fill(i,qe),as=ce.stroke(i,qe),Pe)qe==$s&&Ss<=ke.prox&&(Fe=Ei,Be=Oi,ot=os,At=fi,bt=di,gt=ei,Ke=as);else{let ti=ct[qe];ti!=null&&(Xt[qe]=Ei,Jn[qe]=Oi,yv(ti,os,fi,di),xv(ti,ei,as),ms(ti,Li(Ei),Li(Oi),B,Ie))}}}}if(Pe){let qe=ke.prox,Yt=xr==null?Ss<=qe:Ss>qe||$s!=xr;if(pe||Yt){let ln=ct[0];ln!=null&&(Xt[0]=Fe,Jn[0]=Be,yv(ln,ot,At,bt),xv(ln,gt,Ke),ms(ln,Li(Fe),Li(Be),B,Ie))}}}if($t.show&&Xs)if(x!=null){let[de,ye]=Mn.scales,[Ue,Fe]=Mn.match,[Be,ot]=x.cursor.sync.scales,At=x.cursor.drag;if(Dn=At._x,Un=At._y,Dn||Un){let{left:bt,top:gt,width:Ke,height:qe}=x.select,Yt=x.scales[Be].ori,ln=x.posToVal,On,Ft,cn,hi,Qn,wi=de!=null&&Ue(de,Be),Fi=ye!=null&&Fe(ye,ot);wi&&Dn?(Yt==0?(On=bt,Ft=Ke):(On=gt,Ft=qe),cn=S[de],hi=H(ln(On,Be),cn,j,0),Qn=H(ln(On+Ft,Be),cn,j,0),ha(Qi(hi,Qn),Ln(Qn-hi))):ha(0,j),Fi&&Un?(Yt==1?(On=bt,Ft=Ke):(On=gt,Ft=qe),cn=S[ye],hi=I(ln(On,ot),cn,oe,0),Qn=I(ln(On+Ft,ot),cn,oe,0),fa(Qi(hi,Qn),Ln(Qn-hi))):fa(0,oe)}else $h()}else{let de=Ln(rm-im),ye=Ln(om-sm);if(N.ori==1){let ot=de;de=ye,ye=ot}Dn=Gn.x&&de>=Gn.dist,Un=Gn.y&&ye>=Gn.dist;let Ue=Gn.uni;Ue!=null?Dn&&Un&&(Dn=de>=Ue,Un=ye>=Ue,!Dn&&!Un&&(ye>de?Un=!0:Dn=!0)):Gn.x&&Gn.y&&(Dn||Un)&&(Dn=Un=!0);let Fe,Be;Dn&&(N.ori==0?(Fe=Kr,Be=qt):(Fe=Qr,Be=Qt),ha(Qi(Fe,Be),Ln(Be-Fe)),Un||fa(0,oe)),Un&&(N.ori==1?(Fe=Kr,Be=qt):(Fe=Qr,Be=Qt),fa(Qi(Fe,Be),Ln(Be-Fe)),Dn||ha(0,j)),!Dn&&!Un&&(ha(0,0),fa(0,0))}if(Gn._x=Dn,Gn._y=Un,x==null){if(P){if(vm!=null){let[de,ye]=Mn.scales;Mn.values[0]=de!=null?rs(N.ori==0?qt:Qt,de):null,Mn.values[1]=ye!=null?rs(N.ori==1?qt:Qt,ye):null}pa(op,i,qt,Qt,B,Ie,D)}if(et){let de=P&&Mn.setSeries,ye=ke.prox;xr==null?Ss<=ye&&ss($s,to,!0,de):Ss>ye?ss(null,to,!0,de):$s!=xr&&ss($s,to,!0,de)}}pe&&(he.idx=D,Wh()),b!==!1&&Fn("setCursor")}let Ys=null;Object.defineProperty(i,"rect",{get(){return Ys==null&&da(!1),Ys}});function da(x=!1){x?Ys=null:(Ys=g.getBoundingClientRect(),Fn("syncRect",Ys))}function cm(x,b,P,D,W,j,oe){fe._lock||Xs&&x!=null&&x.movementX==0&&x.movementY==0||(Xh(x,b,P,D,W,j,oe,!1,x!=null),x!=null?vr(null,!0,!0):vr(b,!0,!1))}function Xh(x,b,P,D,W,j,oe,de,ye){if(Ys==null&&da(!1),Qe(x),x!=null)P=x.clientX-Ys.left,D=x.clientY-Ys.top;else{if(P<0||D<0){qt=-10,Qt=-10;return}let[Ue,Fe]=Mn.scales,Be=b.cursor.sync,[ot,At]=Be.values,[bt,gt]=Be.scales,[Ke,qe]=Mn.match,Yt=b.axes[0].side%2==1,ln=N.ori==0?B:Ie,On=N.ori==1?B:Ie,Ft=Yt?j:W,cn=Yt?W:j,hi=Yt?D:P,Qn=Yt?P:D;if(bt!=null?P=Ke(Ue,bt)?a(ot,S[Ue],ln,0):-10:P=ln*(hi/Ft),gt!=null?D=qe(Fe,gt)?a(At,S[Fe],On,0):-10:D=On*(Qn/cn),N.ori==1){let wi=P;P=D,D=wi}}ye&&(b==null||b.cursor.event.type==op)&&((P<=1||P>=B-1)&&(P=zr(P,B)),(D<=1||D>=Ie-1)&&(D=zr(D,Ie))),de?(im=P,sm=D,[Kr,Qr]=fe.move(i,P,D)):(qt=P,Qt=D)}let qh={width:0,height:0,left:0,top:0};function $h(){Wl(qh,!1)}let um,hm,fm,dm;function pm(x,b,P,D,W,j,oe){Xs=!0,Dn=Un=Gn._x=Gn._y=!1,Xh(x,b,P,D,W,j,oe,!0,!1),x!=null&&(Mt(ap,fp,mm,!1),pa(hv,i,Kr,Qr,B,Ie,null));let{left:de,top:ye,width:Ue,height:Fe}=$t;um=de,hm=ye,fm=Ue,dm=Fe}function mm(x,b,P,D,W,j,oe){Xs=Gn._x=Gn._y=!1,Xh(x,b,P,D,W,j,oe,!1,!0);let{left:de,top:ye,width:Ue,height:Fe}=$t,Be=Ue>0||Fe>0,ot=um!=de||hm!=ye||fm!=Ue||dm!=Fe;if(Be&&ot&&Wl($t),Gn.setScale&&Be&&ot){let At=de,bt=Ue,gt=ye,Ke=Fe;if(N.ori==1&&(At=ye,bt=Fe,gt=de,Ke=Ue),Dn&&qs(A,rs(At,A),rs(At+bt,A)),Un)for(let qe in S){let Yt=S[qe];qe!=A&&Yt.from==null&&Yt.min!=kt&&qs(qe,rs(gt+Ke,qe),rs(gt,qe))}$h()}else fe.lock&&(fe._lock=!fe._lock,vr(b,!0,x!=null));x!=null&&(En(ap,fp),pa(ap,i,qt,Qt,B,Ie,null))}function mM(x,b,P,D,W,j,oe){if(fe._lock)return;Qe(x);let de=Xs;if(Xs){let ye=!0,Ue=!0,Fe=10,Be,ot;N.ori==0?(Be=Dn,ot=Un):(Be=Un,ot=Dn),Be&&ot&&(ye=qt<=Fe||qt>=B-Fe,Ue=Qt<=Fe||Qt>=Ie-Fe),Be&&ye&&(qt=qt<Kr?0:B),ot&&Ue&&(Qt=Qt<Qr?0:Ie),vr(null,!0,!0),Xs=!1}qt=-10,Qt=-10,ne.fill(null),vr(null,!0,!0),de&&(Xs=de)}function gm(x,b,P,D,W,j,oe){fe._lock||(Qe(x),ua(),$h(),x!=null&&pa(pv,i,qt,Qt,B,Ie,null))}function _m(){T.forEach(xP),O(i.width,i.height,!0)}Hr(wh,qo,_m);let no={};no.mousedown=pm,no.mousemove=cm,no.mouseup=mm,no.dblclick=gm,no.setSeries=(x,b,P,D)=>{let W=Mn.match[2];P=W(i,b,P),P!=-1&&ss(P,D,!0,!1)},me&&(Mt(hv,g,pm),Mt(op,g,cm),Mt(fv,g,x=>{Qe(x),da(!1)}),Mt(dv,g,mM),Mt(pv,g,gm),yp.add(i),i.syncRect=da);let Xl=i.hooks=t.hooks||{};function Fn(x,b,P){Kn?Nt.push([x,b,P]):x in Xl&&Xl[x].forEach(D=>{D.call(null,i,b,P)})}(t.plugins||[]).forEach(x=>{for(let b in x.hooks)Xl[b]=(Xl[b]||[]).concat(x.hooks[b])});let xm=(x,b,P)=>P,Mn=wn({key:null,setSeries:!1,filters:{pub:Ev,sub:Ev},scales:[A,v[1]?v[1].scale:null],match:[Av,Av,xm],values:[null,null]},fe.sync);Mn.match.length==2&&Mn.match.push(xm),fe.sync=Mn;let vm=Mn.key,Yh=My(vm);function pa(x,b,P,D,W,j,oe){Mn.filters.pub(x,b,P,D,W,j,oe)&&Yh.pub(x,b,P,D,W,j,oe)}Yh.sub(i);function gM(x,b,P,D,W,j,oe){Mn.filters.sub(x,b,P,D,W,j,oe)&&no[x](null,b,P,D,W,j,oe)}i.pub=gM;function _M(){Yh.unsub(i),yp.delete(i),Nn.clear(),mp(wh,qo,_m),c.remove(),Re?.remove(),Fn("destroy")}i.destroy=_M;function Zh(){Fn("init",t,e),ca(e||t.data,!1),z[A]?Gh(A,z[A]):ua(),ie=$t.show&&($t.width>0||$t.height>0),ee=pe=!0,O(t.width,t.height)}return v.forEach(qr),T.forEach(_s),n?n instanceof HTMLElement?(n.appendChild(c),Zh()):n(i,Zh):Zh(),i}Hn.assign=wn;Hn.fmtNum=Tp;Hn.rangeNum=Eh;Hn.rangeLog=Ch;Hn.rangeAsinh=Ep;Hn.orient=Xr;Hn.pxRatio=Ct;Hn.join=cR;Hn.fmtDate=Rp,Hn.tzDate=yR;Hn.sync=My;{Hn.addGap=nP,Hn.clipGaps=Ih;let t=Hn.paths={points:Cy};t.linear=Py,t.stepped=rP,t.bars=oP,t.spline=lP}function Fp(t,e=10,n=2500){return{step:e/n,bins:n,used:0,last:-1,base:null,times:new Float64Array(n),values:Object.fromEntries(t.map(s=>[s,new Float64Array(n).fill(NaN)]))}}function Uh(t){t.used=0,t.last=-1,t.base=null}function Op(t,e,n){if(!Number.isFinite(e))return;t.base===null&&(t.base=e);let i=Math.floor((e-t.base)/t.step);if(i<t.last&&(Uh(t),t.base=e,i=0),i!==t.last){t.used===t.bins&&vP(t),t.times[t.used]=e;for(let o of Object.values(t.values))o[t.used]=NaN;t.used+=1,t.last=i}let r=t.used-1;for(let[o,a]of Object.entries(n)){let l=t.values[o];!l||!Number.isFinite(a)||Math.abs(l[r])>=Math.abs(a)||(l[r]=a)}}function vP(t){let e=t.bins>>3;t.times.copyWithin(0,e);for(let n of Object.values(t.values))n.copyWithin(0,e);t.used-=e}function Bp(t,e){return[t.times.subarray(0,t.used),...e.map(n=>{let i=new Array(t.used);for(let s=0;s<t.used;s++)i[s]=Number.isNaN(t.values[n][s])?null:t.values[n][s];return i})]}function Dy(t,e){let n=Object.keys(e),i=[["time [s]",...n.map(s=>e[s])].join(",")];for(let s=0;s<t.used;s++){let r=n.map(o=>Number.isFinite(t.values[o][s])?t.values[o][s]:"");i.push([t.times[s].toFixed(4),...r].join(","))}return i.join(`
`)+`
`}var ea=10,kp=56,yP=45,Fy=["force","force_x","force_y","force_z","torque","torque_x","torque_y","torque_z","penetration","stretch","energy","model_age","step_cpu","wake_late"],SP=["haptic_rate","contact_rate"],Uy=["x","y","z"],MP=[{id:"force",title:"Force on the hand",unit:"N",least:.001,lines:["force","force_x","force_y","force_z"],names:["size",...Uy],colours:["force","x","y","z"]},{id:"torque",title:"Torque on the hand",unit:"N m",least:1e-6,lines:["torque","torque_x","torque_y","torque_z"],names:["size",...Uy],colours:["torque","x","y","z"]},{id:"penetration",title:"Penetration, below 0: gap",unit:"m",least:1e-9,lines:["penetration"],names:["depth"],colours:["contact"]},{id:"stretch",title:"Coupling stretch",unit:"m",least:1e-9,lines:["stretch"],names:["stretch"],colours:["hand"]},{id:"rates",title:"Contact and haptic rate",unit:"Hz",least:1,lines:["contact_rate","haptic_rate"],names:["contact","haptic"],colours:["contact","held"],slow:!0},{id:"age",title:"Age of the contact model",unit:"s",least:1e-6,lines:["model_age"],names:["age"],colours:["muted"]},{id:"energy",title:"Energy put in by the hand",unit:"J",least:1e-9,lines:["energy"],names:["energy"],colours:["torque"]}];function Oy(t,e,n){let i={pick:n,pointed:null,parent:t,fast:Fp(Fy,ea),slow:Fp(SP,ea,600),plots:[],rows:0,now:0,marks:[],theme:null,floors:{Hz:1e3,s:.001},rested:0},s=Object.assign(document.createElement("div"),{className:"plots-head"});i.moment=Object.assign(document.createElement("span"),{className:"grow moment"}),s.append(i.moment);for(let[r,o,a]of e){let l=Object.assign(document.createElement("button"),{type:"button",textContent:r,title:o});l.setAttribute("aria-label",`${r}: ${o}`),l.addEventListener("click",a),s.append(l)}t.append(s),t.addEventListener("keydown",r=>CP(i,r));for(let r of MP){let o=document.createElement("figure");o.className="plot";let a=document.createElement("figcaption"),l=document.createElement("output"),c=document.createElement("span");c.className="keys",a.append(Object.assign(document.createElement("span"),{textContent:r.title,className:"plot-title"}),c,l);let u=document.createElement("div");u.className="plot-area",o.append(a,u),t.append(o),i.plots.push({spec:r,box:o,area:u,keys:c,value:l,chart:null})}return i}function Fh(t){t.theme=rh();for(let e of t.plots){e.chart?.destroy(),e.keys.replaceChildren(...e.spec.lines.length>1?e.spec.names.map((i,s)=>{let r=Object.assign(document.createElement("i"),{textContent:i});return r.style.setProperty("--tone",St(e.spec.colours[s])),r}):[]);let n=e.area.clientWidth||300;e.chart=new Hn(bP(t,e,n),Bp(By(t,e),e.spec.lines),e.area),e.chart.over.addEventListener("click",()=>{t.pointed&&t.pick(t.pointed.time)})}}var By=(t,{spec:e})=>e.slow?t.slow:t.fast;function bP(t,{spec:e},n){let i={stroke:St("grid"),width:1};return{width:n,height:kp,legend:{show:!1},cursor:{sync:{key:"thigma"},points:{size:5},drag:{x:!1,y:!1}},padding:[6,6,0,0],scales:{x:{time:!1,range:()=>[t.now-ea,t.now]},y:{range:(r,o,a)=>wP(o,a,Math.max(e.least,t.floors[e.unit]??0))}},axes:[{show:!0,size:4,grid:i,ticks:{show:!1},values:()=>[],space:40},{size:52,grid:i,ticks:{show:!1},space:12,gap:4,font:"10px system-ui, sans-serif",stroke:St("muted"),values:(r,o)=>EP(o,e)}],series:[{},...e.lines.map((r,o)=>({stroke:St(e.colours[o]),width:o===0||e.slow?1.6:.8,alpha:o===0||e.slow?1:.75,points:{show:!1},spanGaps:!1,fill:o===0&&!e.slow?`${St(e.colours[o])}1f`:void 0}))],hooks:{draw:[r=>AP(r,t)]}}}function wP(t,e,n){if(!Number.isFinite(t)||!Number.isFinite(e))return[0,n];let i=Math.min(0,t),s=Math.max(0,e,i+n),r=.1*(s-i);return[i<0?i-r:0,s+r]}function EP(t,e){let n=Math.max(...t.map(Math.abs)),{number:i,unit:s}=_d(n,e.unit,e.least),r=n===0?1:Number(i)/n,o=t.length>3?2:1,a=t.length-1-(t.length-1)%o;return t.map((l,c)=>{if(c%o!==0)return null;let u=Number((l*r).toPrecision(2)).toString();return c===a?`${u} ${s}`:u})}function AP(t,e){let{ctx:n,bbox:i}=t;n.save(),n.lineWidth=1,n.setLineDash([3,3]);for(let{time:s,kind:r}of e.marks){if(s<e.now-ea)continue;let o=t.valToPos(s,"x",!0);n.strokeStyle=St(r==="fault"?"bad":"mark"),n.beginPath(),n.moveTo(o,i.top),n.lineTo(o,i.top+i.height),n.stroke()}n.restore()}function ky(t,e,n){t.marks.push({time:e,kind:n}),t.marks=t.marks.filter(i=>i.time>e-ea).slice(-40)}function zy(t,e,n,i){let s=e/i/10;Object.assign(t.floors,{N:s,"N m":.3*s*e,m:.25*n,J:.01*s*e})}function Gy(t,e,n){let i=Object.fromEntries(n.map((r,o)=>[r,o])),s=Fy.filter(r=>i[r]!==void 0);for(let r=0;r<e.rows;r++){let o=c=>e.values[r*e.columns+i[c]],a=Object.fromEntries(s.map(c=>[c,o(c)]));a.force=Math.hypot(a.force_x,a.force_y,a.force_z),a.torque=Math.hypot(a.torque_x,a.torque_y,a.torque_z);let l=e.time+o("t");Op(t.fast,l,a)}t.rows+=e.rows}function Vy(t,e,n,i){Op(t.slow,e,{haptic_rate:n,contact_rate:i})}function Hy(t){Uh(t.fast),Uh(t.slow),t.marks=[]}var TP=1/40;function CP(t,e){let n={ArrowLeft:-1,ArrowRight:1}[e.key];if(!(!n&&e.key!=="Escape"&&e.key!=="Enter"||e.target!==t.parent)){if(e.key==="Enter"){t.pointed&&t.pick(t.pointed.time);return}e.preventDefault();for(let{chart:i}of t.plots){let s=i.over.clientWidth,r=i.cursor.left>=0?i.cursor.left:s,o=n?Math.max(0,Math.min(s-1,r+n*TP*s)):-10;i.setCursor({left:o,top:o<0?-10:.5*kp},!1,!1)}t.rested=0}}function RP(t){let{chart:e}=t.plots[0],{idx:n,left:i}=e.cursor;if(n==null||!(i>=0)||!(n<t.fast.used))return null;let s=r=>t.fast.values[r][n];return{time:t.fast.times[n],force:s("force"),torque:s("torque"),penetration:s("penetration"),stretch:s("stretch")}}var PP=2;function Wy(t,e,n=!1){let i=performance.now();if(i<t.rested||t.parent.hidden||t.parent.offsetParent===null)return;Object.assign(t,{now:e,pointed:RP(t)});let s=t.pointed?`At ${t.pointed.time.toFixed(2)} s, ${(e-t.pointed.time).toFixed(2)} s ago`:`The last ${ea} s; point at a time to read it`;t.moment.textContent!==s&&(t.moment.textContent=s),t.theme!==rh()&&Fh(t);let r=i;queueMicrotask(()=>{r=performance.now()});for(let a of t.plots){let l=Bp(By(t,a),a.spec.lines),c=a.area.clientWidth;c>0&&c!==a.chart.width&&a.chart.setSize({width:c,height:kp}),a.chart.setData(l);let u=IP(t,a,l);a.value.textContent=jn(u(0),a.spec.unit,a.spec.least),[...a.keys.children].forEach((h,f)=>{let d=t.pointed?`${a.spec.names[f]} ${jn(u(f),a.spec.unit,a.spec.least)}`:a.spec.names[f];h.textContent!==d&&(h.textContent=d)})}let o=performance.now()-i;t.rested=1/0,queueMicrotask(()=>{let a=performance.now(),l=(1+(n?PP:0))*(o+a-r);t.rested=a+Math.max(yP,9*l)})}function IP(t,{chart:e},n){let i=e.cursor.left>=0?e.cursor.idx:null;if(i==null)for(i=n[0].length-1;i>0&&n[0][i]>t.now;)i-=1;return s=>i>=0?n[1+s][i]??NaN:NaN}function Xy(t,e){let n=devicePixelRatio||1,i=t.plots.map(({spec:u,chart:h})=>({spec:u,canvas:h.root.querySelector("canvas")})),s=i[0].canvas.width,r=Math.round(22*n),o=Math.round(34*n),a=document.createElement("canvas");a.width=s,a.height=o+i.reduce((u,{canvas:h})=>u+r+h.height,0)+r;let l=a.getContext("2d");l.fillStyle=St("panel"),l.fillRect(0,0,a.width,a.height),l.fillStyle=St("ink"),l.font=`600 ${14*n}px system-ui, sans-serif`,l.fillText(e,10*n,22*n);let c=o;l.font=`${12*n}px system-ui, sans-serif`;for(let{spec:u,canvas:h}of i)l.fillText(u.title,10*n,c+15*n),l.drawImage(h,0,c+r),c+=r+h.height;return a}function qy(t){return Dy(t.fast,{force_x:"force x on the hand [N]",force_y:"force y on the hand [N]",force_z:"force z on the hand [N]",torque_x:"torque x on the hand [N m]",torque_y:"torque y on the hand [N m]",torque_z:"torque z on the hand [N m]",penetration:"penetration [m]",stretch:"coupling stretch [m]",energy:"energy put in by the hand [J]",model_age:"age of the contact model [s]"})}var zp=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"],[1e-9,"n"],[1e-12,"p"]];function $y(t,e){let n=Number.isFinite(t)&&t>0?t:2,[i,s]=zp.find(([r])=>n>=2*r)??zp[zp.length-1];return{scale:i,unit:s+e,decimals:Math.max(1,2-Math.floor(Math.log10(n/i)))}}function Yy(t,{scale:e,decimals:n}){if(t==null||!Number.isFinite(t))return"–";let i=t/e,s=Math.abs(i);return i.toFixed(Math.min(n,s<9.995?2:s<99.95?1:0))}function Zy(t,e,{workspace:n,tolerance:i}){let s=u=>e.find(h=>h.name===u)?.value,r=t?.force>0?t.force:3.3,o=t?.torque>0?t.torque:.1,a=r/(n?.force_scale>0?n.force_scale:1),l=s("coupling_stiffness"),c=s("contact_stiffness");return{force:r,torque:o,stretch:l>0?a/l:10*i,penetration:c>0?Math.max(a/c,i):i}}var jy=(t,e)=>Number.isFinite(t)&&e>0?Math.min(1,Math.abs(t)/e):0;var Jy=[{id:"force",name:"Force",unit:"N",help:"on the hand, as sent to the device; the bar ends at the limit of device and safety"},{id:"torque",name:"Torque",unit:"N m",help:"on the hand, about the handle; the bar ends at the limit of device and safety"},{id:"penetration",name:"Depth",unit:"m",help:"of the deepest contact: how far the surfaces pass into each other, or the gap between them; forces begin before they touch; the bar ends where the contact gives the largest force, or the tolerance"},{id:"stretch",name:"Stretch",unit:"m",help:"from the hand to where it holds the object: the spring that is felt; the bar ends at the limit of the force"}];function Ky(t){let e={parent:t,tiles:{},lines:{}},n=le("div","tiles");for(let{id:r,name:o,help:a}of Jy){let l=le("div",`tile ${r}`);l.title=a;let c=le("span","number"),u=le("span","unit"),h=le("span","name",o),f=le("i","gauge"),d=le("span","limit");l.append(h,c,u,f,d),n.append(l),e.tiles[r]={tile:l,title:h,number:c,unit:u,gauge:f,limit:d}}let i=le("p","situation"),s=le("ul","lines");for(let r of["limit","rows","level","loop","contact","energy"]){let o=le("li",`line ${r}`),a=le("i","dot"),l=le("span");o.append(a,l),s.append(o),e.lines[r]={line:o,text:l,dot:a}}return t.append(n,i,s),e.said=i,e}var Bl=t=>Math.hypot(...t);function LP(t,e,n){for(let{id:i,unit:s}of Jy){let r=t.tiles[i],o=$y(n[i],s),a=jy(e[i],n[i]);Oh(r.number,Yy(i==="penetration"?Math.abs(e[i]):e[i],o)),Oh(r.unit,o.unit),Oh(r.limit,`of ${Number((n[i]/o.scale).toPrecision(2))}`),r.gauge.style.setProperty("--share",a.toFixed(3)),r.tile.classList.toggle("full",a>.9)}Oh(t.tiles.penetration.title,e.penetration<0?"Gap":"Depth")}function Oh(t,e){t.textContent!==e&&(t.textContent=e)}function Qy(t,{shown:e,state:n,scene:i,bodies:s,parameters:r},o=null){if(!e||!i)return;let a=e.penetration>0;if(LP(t,o??{force:Bl(e.force),torque:Bl(e.torque),stretch:e.stretch,penetration:e.penetration},Zy(n?.limits,r,i)),t.parent.classList.toggle("pointed",!!o),FP(t.lines.loop,e,n,i),bi(t.lines.energy,"",`The hand has put in ${jn(e.energy,"J",1e-9)}.`),t.lines.level.line.hidden=t.lines.contact.line.hidden=!!i.world,i.world){t.said.textContent=M0(i,s);for(let h of["limit","rows"])t.lines[h].line.hidden=!0;return}let l=a||Bl(e.contactForce)>0,c={object:i.object.name,statics:i.statics.map(h=>h.name),grasped:(e.bits&1)!==0,armed:(e.bits&6)===2,contacts:e.contactsFound,clusters:e.clusters.length,touching:l},u=(e.bits&Lr.constrained)!==0;t.said.textContent=u?NP(t,c,{snapshot:e,state:n,scene:i,parameters:r}):y0(c);for(let h of["limit","rows"])t.lines[h].line.hidden=!u;UP(t.lines.level,e,i),OP(t.lines.contact,e,n)}function NP(t,e,{snapshot:n,state:i,scene:s,parameters:r}){let o=n.rows.filter(({presses:u})=>u).length,a=r.find(({name:u})=>u==="coupling_stiffness")?.value??null,l=i?.constraint??null,c={pressing:o,stiffness:a,stretch:n.stretch,force:Bl(n.force)/s.workspace.force_scale,heldBack:l?.held_back??0,squeezed:l?.squeezed??0,say:jn};return bi(t.lines.limit,c.heldBack>.01||c.squeezed>.1?"warn":"good",b0(c)),bi(t.lines.rows,l?.left_out>0||l?.halvings>0?"warn":"",DP(n,l)),S0({...e,rows:l?.rows??n.rows.length,pressing:o,newtons:jn(Bl(n.force),"N",.001),stiffness:a===null?null:jn(a,"N/m",1)})}function DP({rows:t},e){if(!e)return"Rows: not counted yet.";let n=[`${oi(e.in_model,"row")} in the contact model`];e.halvings>0&&n.push(`more were needed than fit, so its travel was halved ${e.halvings===1?"once":`${e.halvings} times`}`),e.left_out>0&&n.push(`${oi(e.left_out,"contact")} had no room: nothing may move`),Number.isFinite(e.travel)&&e.travel!==null&&n.push(`free for ${jn(e.travel,"m",1e-6)} around`);let i=w0(t);return i>0&&n.push(`${i} at the edge of ${i===1?"its cone":"their cones"}`),`${n.join("; ")}.`}function bi(t,e,n){t.line.dataset.mood=e,t.text.textContent!==n&&(t.text.textContent=n)}function UP(t,e,n){let i=vd(e.contacts),s=n.object.levels>1?` of ${n.object.levels} levels`:"",r="Level of detail: none in use, as nothing is near.",o=i[0]?.[0]===0?", the original surface":"";i.length===1&&(r=`Level of detail at the contacts: ${i[0][0]}${s}${o}.`),i.length>1&&(r=`Levels of detail at the contacts: ${i.map(([l])=>l).join(", ")}${s}; 0 is the finest.`);let a=E0(e.contacts);bi(t,"",a?`${r} Decided ${a}${a.includes("100 %")?"":"; there is nothing finer elsewhere"}.`:r),t.dot.style.background=i.length>0?Br(i[0][0]):""}function FP(t,e,n,i){let s=e.hapticRate,r=i.rate;if(n?.replay)return bi(t,"",`A recording of a loop at ${Math.round(r)} Hz.`);if(!Number.isFinite(s))return bi(t,"","Haptic loop: not measured yet.");if(n?.run!=="running")return bi(t,"",`Haptic loop: ${n?.run??"unknown"}.`);let o=s>=.99*r,a=n?.timing?.missed??null,l=a===null?"":`, ${oi(a,"frame")} missed`;return o?bi(t,"good",`The loop holds ${Math.round(r)} Hz${l}.`):bi(t,"warn",`The loop runs at ${Math.round(s)} of ${Math.round(r)} Hz${l}.`)}function OP(t,e,n){if(n?.replay){let o=Number.isFinite(e.modelAge)?` The model was ${jn(e.modelAge,"s",1e-6)} old.`:"";return bi(t,"",`Contacts are found again where the object was.${o}`)}if(!Number.isFinite(e.contactRate))return bi(t,"","Contacts: not measured yet.");if(n&&n.run!=="running")return bi(t,"",`Contacts: ${n.run}.`);let i=Number.isFinite(e.modelAge)?`; the model is ${jn(e.modelAge,"s",1e-6)} old`:"",s=n?e.modelWeight>.99?"good":"warn":"",r=e.contactsDropped>0?`; ${e.contactsDropped} did not fit`:"";return bi(t,s,`Contacts found ${Pi(e.contactRate)} times a second, ${jn(e.queryCpu,"s",1e-6)} each${i}${r}.`)}var Gp=[["object","the object"],["hand","where the hand holds it"],["coupling","coupling"],["near","rows near"],["press","rows that press"],["cone","friction cone"]];function eS(t,e,n){let i=!!e&&(e.bits&Lr.constrained)!==0;if(t.hidden=!i,document.body.classList.toggle("constrained",i),!i)return;t.childElementCount===0&&t.replaceChildren(...Gp.map(([c,u])=>{let h=le("span",`swatch row-key ${c}`);return h.append(le("i"),le("b","",u),le("em")),h}));let s=n?"in a hand":Gp[0][1],r=t.children[0].children[1];r.textContent!==s&&(r.textContent=s);let o=e.rows.filter(({presses:c})=>c),a=(e.bits&1)!==0,l={object:null,hand:a?null:0,coupling:a?null:0,near:e.rows.length-o.length,press:o.length,cone:o.filter(({friction:c})=>c>0).length};Gp.forEach(([c],u)=>{let h=t.children[u];h.classList.toggle("active",l[c]!==0);let f=l[c]?`×${l[c]}`:"";h.lastChild.textContent!==f&&(h.lastChild.textContent=f)})}function tS(t,e,n,i=""){let s=Math.min(Bs.length,Math.max(n?.object.levels??1,1));if(t.childElementCount!==s+2){let a=Array.from({length:s},(l,c)=>{let u=le("span","swatch",""),h=c===s-1&&n?.object.levels>s?"+":"";return u.append(le("i"),le("b","",`${c}${h}`),le("em")),u.firstChild.style.background=Br(c),u});t.replaceChildren(le("span","legend-title","Level at contacts"),...a,le("span","legend-browsed"))}let r=new Map;for(let[a,l]of vd(e?.contacts??[])){let c=Math.min(a,Bs.length-1);r.set(c,(r.get(c)??0)+l)}let o=i?`Patches of ${i}`:"";t.lastChild.textContent!==o&&(t.lastChild.textContent=o),[...t.children].slice(1,-1).forEach((a,l)=>{let c=r.get(l)??0;a.classList.toggle("active",c>0);let u=c>0?`×${c}`:"";a.lastChild.textContent!==u&&(a.lastChild.textContent=u)})}var BP=100;function nS(){return{title:"",objects:[],undone:[],done:[],chosen:0}}function kP(t){let e=(n,i)=>({source:n.source??null,name:n.name,unit:n.unit??1,position:[...i.position],quaternion:[...i.quat_xyzw],friction:n.friction??null,mass:n.mass??null,density:n.density??null,size:2*n.radius});return[e(t.object,t.start),...t.statics.map(n=>e(n,n))]}function iS(t,e,n){Object.assign(t,{title:e.title,objects:kP(e)}),t.chosen=Math.min(t.chosen,t.objects.length-1),n||Object.assign(t,{done:[],undone:[]})}function sS(t,e){t.done.push(t.objects),t.done.splice(0,t.done.length-BP),Object.assign(t,{objects:e,undone:[]})}function kl(t){return rS(t,t.done,t.undone)}function Bh(t){return rS(t,t.undone,t.done)}function rS(t,e,n){return e.length===0?!1:(n.push(t.objects),t.objects=e.pop(),t.chosen=Math.min(t.chosen,t.objects.length-1),!0)}function oS(t){t.done.length>0&&(t.objects=t.done.pop()),t.chosen=Math.min(t.chosen,t.objects.length-1)}var Vp=(t,e,n)=>t.map((i,s)=>s===e?{...i,...n}:i),Hp=(t,e)=>t.filter((n,i)=>i!==e),aS=(t,e)=>[t[e],...Hp(t,e)];function lS(t,e,n,i){let{min:s,max:r}=e.report.bounds,o=s.map((h,f)=>.5*n*(h+r[f])),a=s.map((h,f)=>n*(r[f]-h)),l=Math.max(...GP(t,i).map(({center:h,radius:f})=>h[0]+f),-1/0),c=.1*Math.max(...a),u=[(Number.isFinite(l)?l+c+.5*a[0]:0)-o[0],-o[1],-o[2]];return[...t,{source:`file:${e.number}`,name:zP(e.name),unit:n,position:u,quaternion:[0,0,0,1],friction:null,mass:null,density:null,size:Math.max(...a)}]}var zP=t=>t.replace(/\.[^.]*$/,"")||t;function GP(t,e){let n=e?[e.object,...e.statics]:[];return t.map((i,s)=>{let r=n[s];return{center:r?ul(i.quaternion,r.center).map((a,l)=>a+i.position[l]):i.position,radius:r?.radius??.5*i.size}})}function cS({title:t,objects:e}){return{type:"compose",title:t,objects:e.map(({source:n,name:i,unit:s,position:r,quaternion:o,friction:a,mass:l,density:c},u)=>({source:n,name:i,unit:s,position:r,quat_xyzw:o,friction:a,...u===0?{mass:l,density:c}:{}}))}}function uS([t,e,n,i]){let s=Math.max(-1,Math.min(1,2*(i*e-n*t))),r=180/Math.PI;return Math.abs(s)>1-1e-9?[0,Math.sign(s)*90,-2*Math.sign(s)*Math.atan2(t,i)*r]:[Math.atan2(2*(i*t+e*n),1-2*(t*t+e*e))*r,Math.asin(s)*r,Math.atan2(2*(i*n+t*e),1-2*(e*e+n*n))*r]}function hS(t){let[e,n,i]=t.map((s,r)=>{let o=s*Math.PI/360,a=[0,0,0,Math.cos(o)];return a[r]=Math.sin(o),a});return vi(i,vi(n,e))}var zl=1e3;function dS(t,{ask:e,choose:n,handles:i}){let s={parent:t,ask:e,choose:n,handles:i,composition:nS(),scene:null,mode:"translate",isOpen:!1,busy:!1,isOwn:!1,saved:"",refused:"",name:""};return addEventListener("keydown",r=>{!s.isOpen||r.target.closest?.("input, select, dialog")||!(r.ctrlKey||r.metaKey)||r.key.toLowerCase()!=="z"||(r.preventDefault(),Wp(s,r.shiftKey?Bh:kl))}),s}function pS(t,e){t.isOpen=e,es(t)}function mS(t,e){t.scene=e,iS(t.composition,e,t.isOwn),es(t)}function gS(t,e){let{objects:n}=t.composition;for(let{model:i,unit:s}of e)n=lS(n,i,s,t.scene);return t.composition.chosen=n.length-1,Gl(t,n)}function _S(t,e){return Gl(t,Vp(t.composition.objects,t.composition.chosen,e))}async function Gl(t,e){if(t.busy)return es(t),{ok:!1,reason:"the scene before is still being made"};sS(t.composition,e);let n=await xS(t);return n.ok||oS(t.composition),es(t),n}async function Wp(t,e){if(t.busy||!e(t.composition))return;(await xS(t)).ok||(e===kl?Bh:kl)(t.composition),es(t)}async function xS(t){Object.assign(t,{busy:!0,isOwn:!0,saved:"",refused:""}),es(t);let e=await t.ask(cS(t.composition));return Object.assign(t,{busy:!1,isOwn:!1,refused:e.ok?"":e.reason??"The program refused."}),e}async function fS(t,e){let n=t.name.trim()||t.composition.title.replace(/[^A-Za-z0-9 ._-]/g,"").trim(),i=await t.ask({type:"save",name:n,value:e});i.ok||(t.refused=i.reason??"The program refused."),es(t)}function vS(t,{file:e}){Object.assign(t,{saved:e,refused:""}),es(t)}function es(t){let{composition:e,isOpen:n,mode:i,busy:s}=t,r=n&&!s&&e.objects.length>0;if(t.handles(r?e.chosen:null,i,n),!n)return;let o=document.activeElement?.dataset?.field,{objects:a,chosen:l}=e,c=le("div","build-list");c.setAttribute("role","listbox"),c.setAttribute("aria-label","Objects of the scene"),c.append(...a.map((h,f)=>{let d=zn("",()=>{e.chosen=f,es(t)},"open-item");return d.setAttribute("role","option"),d.setAttribute("aria-selected",String(f===l)),d.append(le("b","",h.name),le("span","note",f===0?"in the hand":"stands still")),d}));let u=[VP(t),c];a[l]&&u.push(HP(t,a[l],l)),u.push(WP(t)),t.parent.replaceChildren(...u),t.parent.classList.toggle("busy",s),o&&t.parent.querySelector(`[data-field="${o}"]`)?.focus()}function VP(t){let{composition:e,mode:n,busy:i}=t,s=le("div","build-tools"),r=(l,c)=>{let u=zn(l,()=>{t.mode=c,es(t)},"chip-button");return u.setAttribute("aria-pressed",String(n===c)),u},o=zn("Undo",()=>Wp(t,kl)),a=zn("Redo",()=>Wp(t,Bh));return o.disabled=i||e.done.length===0,a.disabled=i||e.undone.length===0,s.append(r("Move","translate"),r("Turn","rotate"),o,a,zn("Add a mesh",t.choose)),s}function HP(t,e,n){let i=le("div","build-fields"),{objects:s}=t.composition,r=f=>Gl(t,Vp(s,n,f)),o=(f,d,g,y)=>{let p=Object.assign(le("input","value"),{type:"text",value:g,disabled:t.busy});return p.dataset.field=d,p.setAttribute("aria-label",f),p.addEventListener("change",()=>y(p.value,p)),p},a=(f,d,g,y,{open:p=!1}={})=>o(f,d,g===null?"":Pi(g),(m,v)=>{let T=m.trim()===""&&p?null:Number(m.replace(",","."));T!==null&&(m.trim()===""||!Number.isFinite(T))?(t.refused=`"${m}" is not a number.`,es(t)):m!==v.defaultValue&&y(T)}),l=(f,d,...g)=>{let y=le("div","build-row");y.append(le("span","",f),...g,le("span","unit",d)),i.append(y)};l("name","",o("name","name",e.name,f=>r({name:f}))),l("position","mm",...["x","y","z"].map((f,d)=>a(`position ${f}, mm`,`position-${f}`,zl*e.position[d],g=>r({position:e.position.map((y,p)=>p===d?g/zl:y)}))));let c=uS(e.quaternion);l("turned about","°",...["x","y","z"].map((f,d)=>a(`turned about ${f}, degrees`,`turn-${f}`,c[d],g=>r({quaternion:hS(c.map((y,p)=>p===d?g:y))})))),l("friction","",a("friction","friction",e.friction,f=>r({friction:f}),{open:!0})),n===0&&(l("mass","g",a("mass, g","mass",e.mass===null?null:zl*e.mass,f=>r({mass:f===null?null:f/zl,density:null}),{open:!0})),l("or density","kg/m³",a("density, kg/m³","density",e.density,f=>r({density:f,mass:null}),{open:!0}))),/^scene:/.test(e.source??"")||l("unit",`m, ${Pi(zl*e.size)} mm long`,a("metres per unit","unit",e.unit,f=>r({unit:f,size:e.size*f/e.unit}),{}));let u=le("div","build-tools");n>0&&u.append(zn("Take it in the hand",()=>{t.composition.chosen=0,Gl(t,aS(s,n))}));let h=zn("Remove",()=>Gl(t,Hp(s,n)));return h.disabled=s.length<2,u.append(h),i.append(u),i}function WP(t){let e=le("div","build-save"),n=Object.assign(le("input","value"),{type:"text",value:t.name,placeholder:t.composition.title});n.dataset.field="save-name",n.setAttribute("aria-label","Name to save it under"),n.addEventListener("change",()=>{t.name=n.value});let i=zn("Save",()=>fS(t,!1),"primary"),s=zn("Save as one file",()=>fS(t,!0)),r=le("p",t.refused?"refusal":"note",t.refused||(t.saved?`Saved: ${t.saved}`:""));r.setAttribute("role",t.refused?"alert":"status");let o=le("div","build-tools");return o.append(n,i,s),e.append(o,r),e}function SS(t,e){let n=le("p","note","Choose a level to see its convex patches, each in a colour of its own. What contacts use at this moment stands in the colours of the legend."),i=le("div");return t.append(n,i),{list:i,browse:e,rows:[],scene:null}}function MS(t,e){t.scene=e;let n=[e.object,...e.statics];t.rows=n.map((i,s)=>XP(t,i,s)),t.list.replaceChildren(...t.rows.map(i=>i.box))}function XP(t,e,n){let i=le("section","level-row"),s=le("div","level-head"),r=le("i",n===0?"held":"fixed");s.append(r,le("h2","",e.name),le("span","note",oi(e.levels,"level")));let o=le("div","chips");o.setAttribute("role","radiogroup"),o.setAttribute("aria-label",`Level of the ${e.name}`);let a=le("p","note"),l={box:i,about:e,body:n,caption:a,chips:[],level:null},c=[null,...(e.level_list??[]).keys()];for(let u of c){let h=Object.assign(le("button","chip-button",u===null?"as it is":String(u)),{type:"button"});h.setAttribute("role","radio"),h.setAttribute("aria-label",u===null?`${e.name} as it is`:`${e.name}, level ${u}`),u!==null&&u>0&&e.level_list[u].free&&h.classList.add("free"),h.addEventListener("click",()=>yS(t,l,u)),l.chips.push({chip:h,level:u}),o.append(h)}return i.append(s,o,a),yS(t,l,null),l}function yS(t,e,n){let i=e.level!==n;e.level=n;for(let{chip:s,level:r}of e.chips)s.setAttribute("aria-checked",String(r===n));e.caption.textContent=qP(e.about,n),i&&t.browse(e.body,n)}function qP(t,e){if(e===null)return"";let n=t.level_list[e];return e===0?`The original surface: ${oi(n.triangles,"triangle")} in ${oi(n.patches,"convex patch","convex patches")}.`:$d({about:t},e)?`${oi(n.triangles,"triangle")} in ${oi(n.patches,"convex patch","convex patches")}; nowhere more than ${jn(n.deviation,"m",1e-9)} off the original.`:`${oi(n.patches,"group")} of patches below, merged pairwise. No surface of its own: contacts here are with convex hulls.`}function bS(t){return t.rows.filter(e=>e.level!==null).map(e=>`${e.about.name} ${e.level}`).join(", ")}var Xp={ball_joint:{size:.076,triangles:274120},block_on_gear:{size:.1,triangles:1616},blocks:{size:.1,triangles:32},conforming:{size:.2,triangles:2e5},cup_spoon:{size:.2,triangles:149988},ellipsoid:{size:.02,triangles:22002},file_on_cad:{size:.2,triangles:1344},golf:{size:.12,triangles:282764},hammer_on_torus:{size:.24,triangles:1036},jaws:{size:.074,triangles:87514},plate:{size:.1,triangles:2016},simple_cup_spoon:{size:.2,triangles:5340},spoon_in_cup:{size:.2,triangles:149988}};var wS={ball_joint:"Turn the ball in its socket: it has half a millimetre of play.",block_on_gear:"Drag the block over the gear: ridges catch ridges.",blocks:"Turn the upper block about the vertical: its stripes climb out of the others.",conforming:"Press the waves together and turn: everything touches at once.",cup_spoon:"Lead the spoon through the handle of the cup.",ellipsoid:"Roll the ellipsoid over the ball; its tip and its flank feel different.",file_on_cad:"Scrape the file over the flange: rough on rough.",golf:"Tap the ball, then slide the club over its dimples.",hammer_on_torus:"Stroke the ring with the hammer, along and across its ridges.",jaws:"Close the bite, then slide the cusps over each other.",plate:"Draw the probe across the ridges, slowly and fast.",simple_cup_spoon:"Lead the spoon through the handle: few triangles, the same way.",spoon_in_cup:"Nobody holds it: watch the spoon fall into the cup."},ES=t=>wS[t]??"",hU=Object.keys(wS);var $P=96,YP=[["millimetres",.001],["centimetres",.01],["inches",.0254],["metres",1]];function CS(t,{ask:e,send:n,room:i,limit:s,add:r}){let o={dialog:t,ask:e,send:n,room:i,limit:s,add:r,menu:{scenes:[],recordings:[],meshes:[]},name:"",model:null,busy:null};t.addEventListener("click",a=>{a.target===t&&t.close()});for(let a of["dragenter","dragover"])addEventListener(a,l=>{[...l.dataTransfer?.types??[]].includes("Files")&&(l.preventDefault(),document.body.classList.add("dropping"))});return addEventListener("dragleave",a=>{a.relatedTarget||document.body.classList.remove("dropping")}),addEventListener("drop",a=>{a.preventDefault(),document.body.classList.remove("dropping"),LS(o,[...a.dataTransfer?.files??[]])}),o}function RS(t,e){t.menu=e,t.dialog.open&&!t.model&&IS(t)}function PS(t,e){t.name=e,t.model=null,IS(t),t.dialog.open||t.dialog.showModal()}function IS(t){let{scenes:e,recordings:n,meshes:i=[]}=t.menu,s=l=>{let c=le("div","open-list");return c.append(...l.map(({name:u,title:h})=>{let f=zn("",()=>jP(t,u),"open-item");f.append(le("b","",h||u));let d=ES(u)||(h&&h!==u?u:"");return d&&f.append(le("span","note",d)),ZP(f,u),f.setAttribute("aria-current",String(u===t.name)),f})),c},r=Object.assign(le("input"),{type:"file",accept:A0(i),id:"mesh-file",multiple:!0});r.addEventListener("change",()=>LS(t,[...r.files]));let o=le("label","drop-zone");o.htmlFor=r.id,o.append(le("b","","Files of your own"),le("span","note",T0(i)),r);let a=[le("h2","","Open"),o,le("h3","","Scenes"),s(e)];n.length>0&&a.push(le("h3","","Recordings"),s(n)),t.dialog.replaceChildren(...a,qp(t,[zn("Cancel",()=>t.dialog.close())]))}function ZP(t,e){let n=Xp[e];if(!n)return;let i=le("i","open-picture");i.style.backgroundPositionY=`${(-$P*Object.keys(Xp).indexOf(e)).toFixed(0)}px`,i.setAttribute("aria-hidden","true"),t.classList.add("pictured"),t.append(le("span","note",`${Pi(1e3*n.size)} mm, ${oi(n.triangles,"triangle")}`),i)}function qp(t,e,n=""){let i=le("div","dialog-foot"),s=le("p","refusal",n);return s.setAttribute("role","alert"),i.append(s,...e),t.said=s,i}async function jP(t,e){(await $p(t,{type:"open",value:e})).ok&&t.dialog.close()}async function $p(t,e){if(t.busy)return{ok:!1};t.dialog.classList.add("busy"),t.busy=t.ask(e);let n=await t.busy;return t.busy=null,t.dialog.classList.remove("busy"),!n.ok&&t.said&&(t.said.textContent=n.reason??"The program refused."),n}async function LS(t,e){if(e.length<=1){e[0]&&await AS(t,e[0]);return}let n=[];for(let i of e){if(!(await AS(t,i)).ok||t.model?.report===void 0||t.model.report.verdict==="rejected")return;n.push({model:t.model,unit:t.model.unit})}t.dialog.close(),t.add(n)}async function AS(t,e){for(;t.busy;)await t.busy;t.model={name:e.name};let n=Object.assign(le("progress"),{max:1,value:0});t.dialog.replaceChildren(le("h2","",e.name),le("p","note","Sending and looking at it …"),n,qp(t,[zn("Cancel",()=>t.dialog.close())])),t.dialog.open||t.dialog.showModal();let i=new Uint8Array(await e.arrayBuffer()),s=$p(t,{type:"upload",name:e.name.slice(-120),value:i.length});await JP(t,i,n);let r=await s;return r.ok&&e.name.endsWith(".mcap")&&t.dialog.close(),r}async function JP(t,e,n){let i=Math.max(1024,Math.min(t.limit(),65536)-64);for(let s=0;s<e.length&&t.busy;){for(let r=0;r<8&&s<e.length&&t.room()<4*i;r++){if(!t.send(O0(e.subarray(s,s+i))))return;s+=i}n.value=Math.min(1,s/e.length),await new Promise(r=>setTimeout(r,10))}}function NS(t,e){t.model=e;let{report:n}=e,i=n.verdict==="usable",s=n.verdict==="repairable",r=le("p",`verdict ${n.verdict}`,{usable:"Ready to use",repairable:"Needs repair first",rejected:"Cannot be used"}[n.verdict]??n.verdict),o=le("p","",`${oi(n.triangles,"triangle")}, ${n.closed?"closed":"open"}, ${oi(n.components,"part")}.`),a=le("ul","reasons");for(let y of[...n.reasons,...n.warnings])a.append(le("li","",y));let l=Object.assign(le("select"),{id:"mesh-unit"}),c=[...YP.map(([y,p])=>[`${y} (${TS(n,p)})`,p]),[`whatever makes it as large as the object (${TS(n,e.object_radius/n.radius)})`,e.object_radius/n.radius]];l.append(...c.map(([y,p])=>new Option(y,String(p)))),l.value=String(e.unit);let u=Object.assign(le("label","","Its unit is "),{htmlFor:l.id}),h=le("p","unit-choice");h.append(u,l);let f=y=>async()=>{(await $p(t,{type:"place",name:y,value:Number(l.value),repair:s})).ok&&t.dialog.close()},d=s?"Repair and ":"",g=[zn("Cancel",()=>t.dialog.close())];(i||s)&&(g.push(zn("Add it to the scene",async()=>{t.dialog.close(),t.add([{model:e,unit:Number(l.value)}])})),g.push(zn(d?"Repair and touch it":"Touch it",f("touch")),zn(d?"Repair and hold it":"Hold it",f("hold"),"primary"))),t.dialog.replaceChildren(le("h2","",e.name),r,o,a,...i||s?[h]:[],qp(t,g)),t.dialog.open||t.dialog.showModal()}function TS(t,e){let n=e*Math.max(...t.bounds.max.map((i,s)=>i-t.bounds.min[s]));return Number.isFinite(n)?n<.9995?`${Pi(1e3*n)} mm`:`${Pi(n)} m`:"–"}var KP=[.05,.1,.25,.5,1,2,4];function DS(t,e){let n={parent:t,act:e,held:!1,waiting:!1,next:null};n.play=Zn("pause","Pause","P",e.pause),n.slider=Object.assign(document.createElement("input"),{type:"range",min:0,max:1,step:"any"}),n.slider.setAttribute("aria-label","Time in the recording"),n.text=document.createElement("output"),n.slider.addEventListener("input",()=>{n.held=!0,US(n,Number(n.slider.value))});for(let s of["change","blur"])n.slider.addEventListener(s,()=>{n.held=!1});n.speed=Object.assign(document.createElement("select"),{title:"How fast it is shown"}),n.speed.setAttribute("aria-label",n.speed.title),n.speed.append(...KP.map(s=>new Option(`${s} ×`,String(s)))),n.speed.value="1",n.speed.addEventListener("change",()=>e.speed(Number(n.speed.value))),n.strip=document.createElement("canvas"),n.strip.setAttribute("aria-hidden","true"),n.force=[];let i=Object.assign(document.createElement("div"),{className:"track"});return i.append(n.strip,n.slider),t.append(n.play,i,n.speed,n.text),n}async function US(t,e){if(t.waiting){t.next=e;return}t.waiting=!0,await t.act.seek(e),t.waiting=!1;let n=t.next;t.next=null,n!==null&&US(t,n)}function FS(t,{force:e}){t.force=e,t.drawnAt=null}function QP(t){let{clientWidth:e,clientHeight:n}=t.strip,i=St("force"),s=`${e} ${n} ${i}`;if(t.drawnAt===s||e===0)return;t.drawnAt=s,Object.assign(t.strip,{width:e,height:n});let r=t.strip.getContext("2d"),o=t.force.reduce((a,l)=>Math.max(a,l??0),0);r.clearRect(0,0,e,n),r.fillStyle=i,t.force.forEach((a,l)=>{let c=o>0?n*(a??0)/o:0;r.fillRect(l*e/t.force.length,n-c,e/t.force.length+.5,c)})}function OS(t,e,n){let i=e?.replay??null;if(t.parent.hidden=!i,!i)return;let s=t.held||t.waiting?Number(t.slider.value):n?.time??0;t.slider.max=i.seconds,!t.held&&!t.waiting&&(t.slider.value=s),t.slider.setAttribute("aria-valuetext",`${Pr(s)} of ${Pr(i.seconds)}`),t.text.textContent=`${Pr(s)} / ${Pr(i.seconds)}`,document.activeElement!==t.speed&&(t.speed.value=String(i.speed??1)),QP(t);let r=e.run==="paused";al(t.play,r?"play":"pause"),Fo(t.play,r?"Play":"Hold","P")}var BS=26,e2=110,Yp=[["1","+x",[1,0,0]],["2","-x",[-1,0,0]],["3","+y",[0,1,0]],["4","-y",[0,-1,0]],["5","+z",[0,0,1]],["6","-z",[0,0,-1]]];function GS(t,e,n){let i=le("div","compass"),s=document.createElementNS("http://www.w3.org/2000/svg","svg");i.setAttribute("role","group"),i.setAttribute("aria-label","Views along the axes"),s.setAttribute("viewBox","-36 -36 72 72"),s.setAttribute("aria-hidden","true"),i.append(s);let r=Yp.map(([l,c,u])=>{let h=document.createElementNS("http://www.w3.org/2000/svg","line"),f=Object.assign(le("button",`axis axis-${c[1]} ${c[0]==="+"?"plus":"minus"}`,c[0]==="+"?c[1]:""),{type:"button",title:`View from ${c} (${l})`});return f.setAttribute("aria-label",`View from ${c}`),f.addEventListener("click",()=>n(u)),h.classList.add(`axis-${c[1]}`),c[0]==="+"&&s.append(h),i.append(f),{way:new F(...u),line:h,button:f}}),o=l=>{let c=le("div",`ruler ${l}`),u=le("span"),h=le("i");return c.append(u,h),{box:c,text:u,length:h}},a={parent:t,names:e,ends:r,scale:o("ruler-scale"),force:o("ruler-force"),tags:[]};return t.replaceChildren(a.force.box,a.scale.box,i),a}function VS(t,e,n){let{view:i,options:s,canvas:{clientWidth:r,clientHeight:o}}=e;if(!e.object||o===0)return;let{right:a,up:l,forward:c}=cr(i);for(let{way:d,line:g,button:y}of t.ends){let p=BS*d.dot(a),m=-BS*d.dot(l);g.setAttribute("x2",p.toFixed(1)),g.setAttribute("y2",m.toFixed(1)),y.style.transform=`translate(${p.toFixed(1)}px, ${m.toFixed(1)}px)`,y.style.zIndex=d.dot(c)<0?2:1}let u=e.root.localToWorld(e.object.group.position.clone()),h=rl(i,ol(i,u),o)*e.radius;kS(t.scale,h,"m",1e-9);let f=n?.metresPerNewton;t.force.box.hidden=!(f>0)||!s.forces,f>0&&kS(t.force,h/(ep*f),"N",1e-6),i2(t,e,l,r,o)}function kS({text:t,length:e},n,i,s){let r=Y0(e2*n),o=jn(r,i,s).replace(/\.0+(?= )/,"");t.textContent!==o&&(t.textContent=o),e.style.width=`${(r/n).toFixed(1)}px`}var t2=12;function n2(t){let{world:e}=t;return e?e.byNumber.length<=t2?e.byNumber:e.held.map(n=>e.byNumber[n]):Pn(t)}var zS=(t,e)=>t.world?e.about.moves:e===t.object;function i2(t,e,n,i,s){let{options:r,view:o}=e,a=n2(e);if(t.names.hidden=!r.names,!r.names)return;(t.tags.length!==a.length||t.tags.some(({textContent:c},u)=>c!==a[u].about.name))&&(t.tags=a.map(c=>le("span",`name-tag ${zS(e,c)?"held":"fixed"}`,c.about.name)),t.names.replaceChildren(...t.tags));let l=new F;a.forEach((c,u)=>{let{about:h,group:f}=c;e.root.localToWorld(l.set(...h.center).applyQuaternion(f.quaternion).add(f.position)),l.addScaledVector(n,(zS(e,c)?.8:-.8)*h.radius/e.radius).project(o.camera);let d=(l.x+1)/2*i,g=(1-l.y)/2*s,y=l.z<1&&d>0&&d<i&&g>0&&g<s;t.tags[u].style.visibility=y?"":"hidden",t.tags[u].style.transform=`translate(${d.toFixed(0)}px, ${g.toFixed(0)}px) translate(-50%, -50%)`})}function s2(t,e,n){let i=e?[e,...t]:t,s=i[0]?.time??0,r=(i.at(-1)?.time??0)-s;if(!(r>0)||r>1||!(n>0))return{samples:new Float32Array(0),last:i.at(-1)??null};let o=new Float32Array(Math.floor(r*8e3)),a=1;for(let l=0;l<o.length;l++){let c=s+l/8e3;for(;a<i.length-1&&i[a].time<c;)a+=1;let u=(i[a].force-i[a-1].force)/n;o[l]=Number.isFinite(u)?Math.tanh(12*u):0}return{samples:o,last:i.at(-1)}}var HS=()=>({context:null,on:!1,last:null,until:0,played:0});function WS(t){return t.on=!t.on,t.last=null,t.on?(t.context??=new AudioContext,t.context.resume()):t.context?.suspend(),t.on}function XS(t,e,n,i){if(!t.on||!t.context)return;let s=Array.from({length:e.rows},(h,f)=>{let d=g=>e.values[f*e.columns+n[g]];return{time:e.time+d("t"),force:Math.hypot(d("force_x"),d("force_y"),d("force_z"))}}),{samples:r,last:o}=s2(s,t.last,i);if(t.last=o,r.length===0)return;let{context:a}=t,l=a.createBuffer(1,r.length,8e3);l.copyToChannel(r,0);let c=new AudioBufferSourceNode(a,{buffer:l});c.connect(a.destination);let u=a.currentTime;(t.until<u||t.until>u+3*.08)&&(t.until=u+.08),c.start(t.until),t.until+=r.length/8e3,t.played+=1}function qS(t,e,n=()=>{}){let i=e.map(([r,o])=>{let a=Object.assign(document.createElement("button"),{type:"button",textContent:o});return a.setAttribute("role","tab"),a.setAttribute("aria-controls",r),a.addEventListener("click",()=>s(r)),{id:r,tab:a}});function s(r){for(let{id:o,tab:a}of i)a.setAttribute("aria-selected",String(o===r)),a.tabIndex=o===r?0:-1,document.getElementById(o).hidden=o!==r;n(r)}return t.addEventListener("keydown",({key:r})=>{let o={ArrowRight:1,ArrowLeft:-1}[r],a=i.findIndex(({tab:c})=>c===document.activeElement);if(!o||a<0)return;let l=i[(a+o+i.length)%i.length];s(l.id),l.tab.focus()}),t.append(...i.map(({tab:r})=>r)),s(e[0][0]),s}function Vs(t,e=null,n=null){let i=document.getElementById("veil");if(i.hidden=!t,i.classList.toggle("working",e!==null),!t){i.replaceChildren();return}if(e!==null&&i.querySelector("progress")){i.querySelector("p").textContent=t,i.querySelector("progress").value=e;return}let s=Object.assign(document.createElement("p"),{textContent:t}),r=Object.assign(document.createElement("progress"),{max:1,value:e??0});r.setAttribute("aria-label","How far it is");let o=Object.assign(document.createElement("button"),{type:"button",className:"primary",textContent:"Cancel"});o.addEventListener("click",n??(()=>{})),i.replaceChildren(s,...e===null?[]:[r],...n?[o]:[])}var Gt=t=>document.getElementById(t),r2=50,Se={connected:!1,hello:null,scene:null,meshes:new Map,state:null,parameters:[],snapshot:null,shown:null,bodies:null,refusal:null,counts:{snapshot:0,bodies:0,channels:0,mesh:0,event:0},holding:!1,turned:!1,trouble:null,progress:null,fresh:!1,asking:!1,sent:0,faultName:()=>Se.hello?.faults?.[Se.snapshot?.fault??0]??"fault"},_r=k0(),o2=L0(),Ze=null,Di=null,na=null,gr=null,Ni=Oy(Gt("plots"),[["PNG","Save the plots as a picture",()=>Xy(Ni,x2()).toBlob(t=>YS(ZS("png"),t))],["CSV","Save the plots as a table",()=>YS(ZS("csv"),new Blob([qy(Ni)],{type:"text/csv"}))]],t=>Se.state?.replay&&nn.seek(t)),a2=Ky(Gt("readouts")),Jp=HS(),eM=SS(Gt("levels"),(t,e)=>Ze&&Pn(Ze)[t]&&vx(Ze,Pn(Ze)[t],e)),kh=CS(Gt("opener"),{ask:t=>ks(Di,t),send:t=>Lx(Di,t),room:()=>Nx(Di),limit:()=>Se.hello?.max_message??4096,add:t=>{nM("build"),gS(sa,t)}}),sa=dS(Gt("build"),{ask:t=>ks(Di,t),choose:()=>{nn.open(),Gt("mesh-file").click()},handles:(t,e,n)=>{Ze&&(gx(Ze,n),n&&!gr&&(gr=Tx(Ze,i=>_S(sa,i))),gr&&tp(gr,t,e))}}),l2=iv(Gt("parameters"),(t,e)=>ks(Di,{type:"set",name:t,value:e}));async function gs(t){let e=await ks(Di,t);return e.ok||(Se.refusal={text:e.reason??"The program refused.",until:performance.now()/1e3+6}),e}var nn={open:()=>Gt("opener").open?Gt("opener").close():PS(kh,Se.scene?.name??""),seek:t=>gs({type:"seek",value:t}),pause:()=>gs({type:"pause",value:Se.state?.run!=="paused"}),step:()=>gs({type:"step",value:1}),reset:()=>gs({type:"reset"}),record:()=>gs({type:"record",value:!Se.state?.recording}),device:t=>gs({type:"use_device",value:t}).then(e=>Kp(e.ok&&t.startsWith("web:"))),help:()=>Gt("help").open?Gt("help").close():c2(),theme:()=>h2(),view:t=>{Ze&&(yx(Ze,{[t]:!Ze.options[t]}),Md(ra,Ze.options))},fit:()=>Ze&&Gu(Ze.view),speed:t=>gs({type:"speed",value:t}),sound:()=>Sd(ra,WS(Jp)),add:()=>$S("add"),remove:()=>$S("remove"),look:t=>Ze&&_0(Ze.view,t),zoom:t=>Ze&&Uo(Ze.view,t)};function $S(t){let e=$x(t,Se.scene,oa.last);e!==null?gs({type:t,value:e}):Se.refusal={text:"Take hold of a body first: the one held last is the one that goes.",until:performance.now()/1e3+6}}function c2(){Gt("help").showModal(),Gt("help").scrollTop=0}var ra=C0(nn),u2=GS(Gt("rulers"),Gt("names"),nn.look),tM=DS(Gt("replay"),nn),h2=s_(()=>{Ze&&mh(Ze),Fh(Ni)}),f2={hello:t=>{Se.hello=t},scene:t=>{let e=t.refined&&Se.snapshot!==null;if(Se.scene=t,Se.meshes.clear(),MS(eM,t),e){Se.bodies=null;return}Se.scene.refined=!1,Se.snapshot=Se.shown=Se.bodies=null,Se.fresh=!1,document.body.classList.toggle("world",!!t.world),t.world&&["parameters","levels","build"].some(n=>!Gt(n).hidden)&&nM("plots"),Vs("Loading the objects …")},mesh:t=>{if(Se.counts.mesh+=1,Se.meshes.set(t.number,t),![Se.scene.object,...Se.scene.statics].map(i=>i.mesh).every(i=>Se.meshes.has(i)))return;let n=Se.scene.refined;gr&&!n&&tp(gr,null),Ze&&px(Ze,Se.scene,Se.meshes,n),mS(sa,Se.scene),n||Vs(Se.trouble)},level:t=>{Ze&&_x(Ze,t)},relief:t=>{Ze&&xx(Ze,t)},strip:t=>FS(tM,t),menu:t=>RS(kh,t),model:t=>NS(kh,t),saved:t=>vS(sa,t),progress:({what:t,share:e})=>{Se.progress=t,t?(Gt("opener").close(),Vs(`${t[0].toUpperCase()}${t.slice(1)} …`,e,()=>gs({type:"cancel"}))):Vs(Se.trouble)},parameters:t=>{Se.parameters=t.list,sv(l2,t.list)},state:t=>{Se.state&&Se.state.session!==t.session&&d2(),Se.state=t,Kp(t.holder==="you")},event:t=>{Se.counts.event+=1,ov(Gt("events"),t),ky(Ni,t.time,t.kind),["recording_ended","held_back","squeezed"].includes(t.kind)&&(Se.refusal={text:`${Wu(t)}.`,until:performance.now()/1e3+10})},bodies:t=>{Se.counts.bodies+=1,Se.bodies=t,Se.fresh=Se.snapshot!==null},camera:t=>{Ze&&md(Ze.view,t)},channels:t=>{Se.counts.channels+=1;let e=["t",...Se.hello.channels.map(n=>n.name).filter(n=>n!=="t")];Gy(Ni,t,e),XS(Jp,t,Object.fromEntries(e.map((n,i)=>[n,i])),Se.state?.limits?.force??tm())},snapshot:t=>{Se.counts.snapshot+=1;let e=t.bits&~(Se.snapshot?.bits??0);Se.snapshot=t,e&Lr.fault&&(_r.clutch=!1),Se.fresh=!0,t.metresPerNewton>0&&zy(Ni,Se.scene.object.radius,Se.scene.tolerance,t.metresPerNewton),Vy(Ni,t.time,t.hapticRate,t.contactRate)}};function d2(){_r.clutch=!1,Ze&&md(Ze.view,null),Hy(Ni),Gt("events").replaceChildren()}function p2(t){Se.connected=!1,Kp(!1),_r.clutch=!1,Zu(_r),document.body.classList.add("lost"),Se.progress=null,Vs(`${t} Nothing is felt or shown any more. ${Di?.stopped?"":"Trying again …"}`)}function m2(){Se.connected=!0,document.body.classList.remove("lost"),Vs(null)}var oa=Xx({session:Se,hand:_r,request:gs,get stage(){return Ze},get link(){return Di},get xr(){return na},get gizmo(){return gr}}),{player:ia}=oa,Kp=t=>xh(oa,t),Qp=()=>Zx(oa);document.addEventListener("visibilitychange",()=>{document.hidden&&Qp()});addEventListener("pagehide",Qp);addEventListener("keydown",t=>{if(t.target.closest?.("input, select, textarea")||t.ctrlKey||t.metaKey||t.altKey)return;let i={" ":()=>_r.clutch?ia.letGo():ia.mayMove()&&ia.press(),p:nn.pause,".":nn.step,r:nn.reset,f:nn.fit,o:nn.open,"?":nn.help,h:nn.help,l:()=>nn.view("wireframe"),g:()=>nn.view("ghost"),c:()=>nn.view("contacts"),a:()=>nn.view("forces"),n:()=>nn.view("names"),s:nn.sound,"+":()=>nn.zoom(.87),"-":()=>nn.zoom(1.15),...Object.fromEntries(Yp.map(([s,,r])=>[s,()=>nn.look(r)]))}[t.key.length===1?t.key.toLowerCase():""];!i||t.key===" "&&t.target.closest?.("button")||(t.preventDefault(),i())});function g2(){try{Ze=dx(Gt("scene"),new URLSearchParams(location.search).get("picture"))}catch(t){return Se.trouble="This browser shows no WebGL 2, so there is no picture; numbers and plots work. Hardware acceleration may be off in its settings.",Vs(Se.trouble),console.warn(String(t.message??t)),null}return document.body.classList.toggle("plain",Ze.plain),Ze.plain&&(Ze.done=t=>setTimeout(()=>document.hidden||rM(performance.now()),t)),Ze.wants=(t,e)=>ks(Di,{type:"level",mesh:t,value:e}),mh(Ze),Md(ra,Ze.options),new ResizeObserver(()=>Tl(Ze)).observe(Gt("stage")),Tl(Ze),_2(),Jx(ia)}async function _2(){na=Gx({stage:Ze,player:ia,leave:Qp,moment:sM,changed:()=>yd(ra,na.mode),take:()=>{Se.state?.devices.includes("web:")&&!Se.state.device.startsWith("web:")&&nn.device("web:")},strength:()=>Math.min(1,em()/tm())}),R0(ra,await zx(),t=>Hx(na,t).catch(({message:e})=>{Se.refusal={text:`The headset: ${e}`,until:performance.now()/1e3+6}}))}function YS(t,e){let n=Object.assign(document.createElement("a"),{href:URL.createObjectURL(e),download:t});n.click(),setTimeout(()=>URL.revokeObjectURL(n.href),1e4)}var ZS=t=>`thigma-${(Se.snapshot?.time??0).toFixed(1)}s.${t}`,ta=g2();av(Gt("help"));var x2=()=>`${Se.scene?.title??""}, to ${(Se.snapshot?.time??0).toFixed(1)} s`,nM=qS(Gt("tabs"),[["plots","Plots"],["parameters","Parameters"],["levels","Levels"],["events","Events"],["build","Scene"]],t=>pS(sa,t==="build"));Fh(Ni);Vs("Connecting …");var jS=/^#token=([0-9a-f]+)$/.exec(location.hash)?.[1];Di=Rx(`${location.protocol==="https:"?"wss":"ws"}://${location.host}/live${jS?`?token=${jS}`:""}`,{message:t=>f2[t.type??t.kind]?.(t),opened:m2,lost:p2});setInterval(Cl,r2,oa);var v2=250,y2=8,S2=100,Zp=performance.now(),iM=0,JS=0,KS=0,QS=0;function sM(){Se.fresh&&(Se.shown=Se.snapshot,Ze&&El(Ze,Se.shown,Se.bodies),Se.fresh=!1)}function M2(){return na?.session||Ze&&!Sx(Ze)||(sM(),!Ze||!Ex(Ze))?!1:(iM+=1,VS(u2,Ze,Se.shown),!0)}var b2=()=>!!(Ze?.plain&&Se.progress);function jp(t){Ze?.plain&&!document.hidden?setTimeout(()=>jp(performance.now()),y2):requestAnimationFrame(jp),ta&&tv(ta,(t-Zp)/1e3,em(),tm()),ta&&ev(ta,(t-Zp)/1e3),Zp=t,Cl(oa),rM(t)}function rM(t){if(b2()&&t<QS)return;QS=t+v2;let e=M2();Wy(Ni,Se.shown?.time??0,Ze?.plain);let n=performance.now();n<KS+S2&&!(e&&n>=JS)||(w2(t/1e3,em()),KS=n,JS=10*performance.now()-9*n)}var em=()=>Se.snapshot?Math.hypot(...Se.snapshot.force):0;function tm(){let t=Se.snapshot?.metresPerNewton;return t>0&&Se.scene?Se.scene.object.radius/t:3}function w2(t,e){P0(ra,Se),Qy(a2,Se,Ni.pointed),eS(Gt("row-legend"),Se.shown,!!Ze?.world),tS(Gt("legend"),Se.shown,Se.scene,bS(eM)),OS(tM,Se.state,Se.shown),I0(Gt("hint"),N0(o2,Se,{now:t,newtons:e,holding:Se.holding&&_r.clutch,turned:Se.turned,touch:ta?.touch??matchMedia("(pointer: coarse)").matches},nn))}requestAnimationFrame(jp);window.thigma={session:Se,hand:_r,input:ta,plots:Ni,sound:Jp,player:ia,act:nn,ask:t=>ks(Di,t),get stage(){return Ze},get link(){return Di},get xr(){return na},builder:sa,opener:kh,get gizmo(){return gr},get drawn(){return iM}};})();
